<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Not while a game is running.</source>
        <translation>No mientras haya una partida en marcha.</translation>
    </message>
    <message>
        <source>Only while a game is running.</source>
        <translation>Solo mientras haya una partida en marcha.</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Seleccione algo primero.</translation>
    </message>
    <message>
        <source>Select at least two objects first.</source>
        <translation>Seleccione al menos dos objetos primero.</translation>
    </message>
    <message>
        <source>Select nodes first, with the node tool.</source>
        <translation>Seleccione nodos primero, con la herramienta de nodos.</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Agrupar</translation>
    </message>
    <message>
        <source>Make one thing of what is selected; a double click gets at its parts</source>
        <translation>Hacer una sola cosa de lo seleccionado; con doble clic se llega a sus partes</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>&amp;Desagrupar</translation>
    </message>
    <message>
        <source>Take the selected groups apart</source>
        <translation>Deshacer los grupos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>&amp;Ocultar</translation>
    </message>
    <message>
        <source>Show the selection no longer; it is played all the same</source>
        <translation>Dejar de mostrar la selección; en el juego sigue estando</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>A&amp;islar</translation>
    </message>
    <message>
        <source>Hide everything but the selection</source>
        <translation>Ocultar todo menos la selección</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>&amp;Mostrar todo</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>Mostrar todo lo que está oculto</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Bloquear</translation>
    </message>
    <message>
        <source>Keep the selection from being selected, moved and removed</source>
        <translation>Impedir que la selección se seleccione, se mueva o se elimine</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>Desb&amp;loquear todo</translation>
    </message>
    <message>
        <source>Let everything that is locked be changed again</source>
        <translation>Permitir de nuevo cambios en todo lo bloqueado</translation>
    </message>
    <message>
        <source>To &amp;Front</source>
        <translation>&amp;Traer al frente</translation>
    </message>
    <message>
        <source>Draw the selection above everything</source>
        <translation>Dibujar la selección por encima de todo</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>Traer ade&amp;lante</translation>
    </message>
    <message>
        <source>Draw the selection above the next object that overlaps it</source>
        <translation>Dibujar la selección por encima del siguiente objeto que la solapa</translation>
    </message>
    <message>
        <source>&amp;Backward</source>
        <translation>Enviar &amp;atrás</translation>
    </message>
    <message>
        <source>Draw the selection below the next object that overlaps it</source>
        <translation>Dibujar la selección por debajo del siguiente objeto que la solapa</translation>
    </message>
    <message>
        <source>To Ba&amp;ck</source>
        <translation>Enviar al &amp;fondo</translation>
    </message>
    <message>
        <source>Draw the selection below everything</source>
        <translation>Dibujar la selección por debajo de todo</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>Bordes &amp;izquierdos</translation>
    </message>
    <message>
        <source>Bring the left edges of the selected objects to that of the leftmost</source>
        <translation>Llevar los bordes izquierdos de los objetos al del que está más a la izquierda</translation>
    </message>
    <message>
        <source>&amp;Centers on a Vertical Line</source>
        <translation>&amp;Centros en una vertical</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects above each other</source>
        <translation>Poner los centros de los objetos uno sobre otro</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>Bordes &amp;derechos</translation>
    </message>
    <message>
        <source>Bring the right edges of the selected objects to that of the rightmost</source>
        <translation>Llevar los bordes derechos de los objetos al del que está más a la derecha</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>Bordes &amp;superiores</translation>
    </message>
    <message>
        <source>Bring the top edges of the selected objects to that of the highest</source>
        <translation>Llevar los bordes superiores de los objetos al del que está más arriba</translation>
    </message>
    <message>
        <source>C&amp;enters on a Horizontal Line</source>
        <translation>C&amp;entros en una horizontal</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects beside each other</source>
        <translation>Poner los centros de los objetos uno junto a otro</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>Bordes in&amp;feriores</translation>
    </message>
    <message>
        <source>Bring the bottom edges of the selected objects to that of the lowest</source>
        <translation>Llevar los bordes inferiores de los objetos al del que está más abajo</translation>
    </message>
    <message>
        <source>Space Left Edges Evenly</source>
        <translation>Repartir bordes izquierdos</translation>
    </message>
    <message>
        <source>Distribute the left edges between those of the outermost objects</source>
        <translation>Distribuir los bordes izquierdos entre los de los objetos extremos</translation>
    </message>
    <message>
        <source>Space Centers Evenly Across</source>
        <translation>Repartir centros a lo ancho</translation>
    </message>
    <message>
        <source>Distribute the centers from left to right</source>
        <translation>Distribuir los centros de izquierda a derecha</translation>
    </message>
    <message>
        <source>Make &amp;Gaps Across Equal</source>
        <translation>Igualar huecos en &amp;horizontal</translation>
    </message>
    <message>
        <source>Distribute the objects from left to right with the same gap between them</source>
        <translation>Distribuir los objetos de izquierda a derecha con el mismo hueco entre ellos</translation>
    </message>
    <message>
        <source>Space Bottom Edges Evenly</source>
        <translation>Repartir bordes inferiores</translation>
    </message>
    <message>
        <source>Distribute the bottom edges between those of the outermost objects</source>
        <translation>Distribuir los bordes inferiores entre los de los objetos extremos</translation>
    </message>
    <message>
        <source>Space Centers Evenly Upwards</source>
        <translation>Repartir centros a lo alto</translation>
    </message>
    <message>
        <source>Distribute the centers from bottom to top</source>
        <translation>Distribuir los centros de abajo arriba</translation>
    </message>
    <message>
        <source>Make Gaps &amp;Upwards Equal</source>
        <translation>Igualar huecos en &amp;vertical</translation>
    </message>
    <message>
        <source>Distribute the objects from bottom to top with the same gap between them</source>
        <translation>Distribuir los objetos de abajo arriba con el mismo hueco entre ellos</translation>
    </message>
    <message>
        <source>New &amp;Layer</source>
        <translation>Nueva &amp;capa</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Above</source>
        <translation>Mover a la capa &amp;superior</translation>
    </message>
    <message>
        <source>Move the selection to the next higher layer</source>
        <translation>Mover la selección a la capa de encima</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Below</source>
        <translation>Mover a la capa in&amp;ferior</translation>
    </message>
    <message>
        <source>Move the selection to the next lower layer, or out of all layers</source>
        <translation>Mover la selección a la capa de debajo, o fuera de todas las capas</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Unión</translation>
    </message>
    <message>
        <source>Make one body of the selected polygons</source>
        <translation>Hacer un solo cuerpo de los polígonos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Diferencia</translation>
    </message>
    <message>
        <source>Cut the upper polygons out of the lowest one</source>
        <translation>Recortar del polígono más bajo los de encima</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>&amp;Intersección</translation>
    </message>
    <message>
        <source>Keep what the selected polygons have in common</source>
        <translation>Conservar lo que los polígonos seleccionados tienen en común</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Deshacer el último cambio</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>No hay nada que deshacer.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Volver a hacer el cambio</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>No hay nada que rehacer.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Cor&amp;tar</translation>
    </message>
    <message>
        <source>Move the selection to the clipboard</source>
        <translation>Mover la selección al portapapeles</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copiar</translation>
    </message>
    <message>
        <source>Copy the selection to the clipboard as text</source>
        <translation>Copiar la selección al portapapeles como texto</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Pegar</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard at the pointer</source>
        <translation>Insertar lo que hay en el portapapeles donde está el puntero</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>Pegar en su &amp;sitio</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard where it was copied</source>
        <translation>Insertar lo que hay en el portapapeles en el lugar donde se copió</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>D&amp;uplicar</translation>
    </message>
    <message>
        <source>Copy the selection one grid step away</source>
        <translation>Copiar la selección a un paso de cuadrícula</translation>
    </message>
    <message>
        <source>Duplicat&amp;e in Place</source>
        <translation>Duplicar en su s&amp;itio</translation>
    </message>
    <message>
        <source>Copy the selection onto itself; what is done to the copy can be repeated</source>
        <translation>Copiar la selección sobre sí misma; lo que se haga con la copia se puede repetir</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>Eliminar la selección</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Seleccionar t&amp;odo</translation>
    </message>
    <message>
        <source>Select every object</source>
        <translation>Seleccionar todos los objetos</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>Dese&amp;leccionar</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>No seleccionar nada</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>In&amp;vertir selección</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Seleccionar lo que no está seleccionado</translation>
    </message>
    <message>
        <source>Select Same &amp;Kind</source>
        <translation>Seleccionar &amp;mismo tipo</translation>
    </message>
    <message>
        <source>Select all objects of the same kind as those selected</source>
        <translation>Seleccionar todos los objetos del mismo tipo que los seleccionados</translation>
    </message>
    <message>
        <source>Select Same Ta&amp;gs</source>
        <translation>Seleccionar mismas eti&amp;quetas</translation>
    </message>
    <message>
        <source>Select all bodies with the same tags as those selected</source>
        <translation>Seleccionar todos los cuerpos con las mismas etiquetas que los seleccionados</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>Add an SVG drawing, a map of Tiled or a scene of R.U.B.E. to the level</source>
        <translation>Añadir al nivel un dibujo SVG, un mapa de Tiled o una escena de R.U.B.E.</translation>
    </message>
    <message>
        <source>&amp;Export As…</source>
        <translation>E&amp;xportar como…</translation>
    </message>
    <message>
        <source>Write a picture of the level, as PNG or SVG</source>
        <translation>Guardar una imagen del nivel, como PNG o SVG</translation>
    </message>
    <message>
        <source>E&amp;xport Again</source>
        <translation>Exportar &amp;otra vez</translation>
    </message>
    <message>
        <source>Write the picture once more, to the same file in the same way</source>
        <translation>Guardar la imagen una vez más, en el mismo archivo y del mismo modo</translation>
    </message>
    <message>
        <source>Screens&amp;hot</source>
        <translation>Captura de pan&amp;talla</translation>
    </message>
    <message>
        <source>Write what the canvas shows to your pictures</source>
        <translation>Guardar lo que muestra el lienzo entre sus imágenes</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nuevo</translation>
    </message>
    <message>
        <source>Start an empty level</source>
        <translation>Empezar un nivel vacío</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Open a level file</source>
        <translation>Abrir un archivo de nivel</translation>
    </message>
    <message>
        <source>Reopen Closed &amp;Level</source>
        <translation>Rea&amp;brir nivel cerrado</translation>
    </message>
    <message>
        <source>Open again the level that was closed last</source>
        <translation>Abrir de nuevo el último nivel que se cerró</translation>
    </message>
    <message>
        <source>Q&amp;uick Open…</source>
        <translation>A&amp;pertura rápida…</translation>
    </message>
    <message>
        <source>Find a level by a few letters of its name: recent ones, those beside it, and those that come with the program</source>
        <translation>Buscar un nivel por unas letras de su nombre: los recientes, los que están junto al actual y los que vienen con el programa</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Write the level to its file</source>
        <translation>Guardar el nivel en su archivo</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>G&amp;uardar como…</translation>
    </message>
    <message>
        <source>Write the level to another file</source>
        <translation>Guardar el nivel en otro archivo</translation>
    </message>
    <message>
        <source>Reloa&amp;d</source>
        <translation>R&amp;ecargar</translation>
    </message>
    <message>
        <source>Read the level from its file again; Undo brings back what it is now</source>
        <translation>Leer de nuevo el nivel de su archivo; Deshacer recupera lo que es ahora</translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Work…</source>
        <translation>Recuperar traba&amp;jo sin guardar…</translation>
    </message>
    <message>
        <source>Show what was left unsaved when the program ended all of a sudden</source>
        <translation>Mostrar lo que quedó sin guardar cuando el programa terminó de repente</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Close this level and its window</source>
        <translation>Cerrar este nivel y su ventana</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>Close all windows and leave the program</source>
        <translation>Cerrar todas las ventanas y salir del programa</translation>
    </message>
    <message>
        <source>&amp;Find Action…</source>
        <translation>Buscar &amp;acción…</translation>
    </message>
    <message>
        <source>Find actions, panels, levels, objects and problems by a few letters</source>
        <translation>Buscar acciones, paneles, niveles, objetos y problemas por unas letras</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>&amp;Teclas…</translation>
    </message>
    <message>
        <source>Show what the keys do</source>
        <translation>Mostrar lo que hacen las teclas</translation>
    </message>
    <message>
        <source>Keyboard &amp;Shortcuts…</source>
        <translation>Atajos de tec&amp;lado…</translation>
    </message>
    <message>
        <source>Give other keys to actions, or the keys of Tiled, Inkscape or Blender</source>
        <translation>Dar otras teclas a las acciones, o las teclas de Tiled, Inkscape o Blender</translation>
    </message>
    <message>
        <source>&amp;About SpaceTow Studio…</source>
        <translation>Acerca &amp;de SpaceTow Studio…</translation>
    </message>
    <message>
        <source>Show version and license</source>
        <translation>Mostrar la versión y la licencia</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>Pro&amp;blema siguiente</translation>
    </message>
    <message>
        <source>Go to the next problem of the level</source>
        <translation>Ir al siguiente problema del nivel</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>Problema &amp;anterior</translation>
    </message>
    <message>
        <source>Go to the problem before</source>
        <translation>Ir al problema anterior</translation>
    </message>
    <message>
        <source>&amp;Fix Problem</source>
        <translation>Co&amp;rregir problema</translation>
    </message>
    <message>
        <source>Cure the problem that was gone to last, where there is a fix for it</source>
        <translation>Remediar el último problema visitado, si hay una corrección</translation>
    </message>
    <message>
        <source>Fix All &amp;Safe Problems</source>
        <translation>Corregir &amp;todo lo seguro</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Remediar todos los problemas cuya corrección no cambia nada intencionado</translation>
    </message>
    <message>
        <source>&amp;Hide Problem</source>
        <translation>&amp;Ocultar problema</translation>
    </message>
    <message>
        <source>Never show the problem that was gone to last in this level, or show it again</source>
        <translation>No mostrar más en este nivel el último problema visitado, o volver a mostrarlo</translation>
    </message>
    <message>
        <source>Insert &amp;Midpoints</source>
        <translation>Insertar puntos &amp;medios</translation>
    </message>
    <message>
        <source>Insert a node in the middle of each selected segment, or of all</source>
        <translation>Insertar un nodo en el medio de cada segmento seleccionado, o de todos</translation>
    </message>
    <message>
        <source>D&amp;elete Segments</source>
        <translation>&amp;Eliminar segmentos</translation>
    </message>
    <message>
        <source>Remove the segments between selected nodes and leave the chain open there</source>
        <translation>Quitar los segmentos entre los nodos seleccionados y dejar ahí abierta la cadena</translation>
    </message>
    <message>
        <source>Select two nodes next to each other first, with the node tool.</source>
        <translation>Seleccione primero dos nodos contiguos, con la herramienta de nodos.</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>Unir &amp;nodos</translation>
    </message>
    <message>
        <source>Weld two end nodes, or two neighbours, into one in the middle</source>
        <translation>Fundir dos nodos extremos, o dos vecinos, en uno en el medio</translation>
    </message>
    <message>
        <source>Select two ends of walls or lines first, with the node tool.</source>
        <translation>Seleccione primero dos extremos de muros o líneas, con la herramienta de nodos.</translation>
    </message>
    <message>
        <source>Join by a &amp;Segment</source>
        <translation>Unir con un &amp;segmento</translation>
    </message>
    <message>
        <source>Join two end nodes by a new segment</source>
        <translation>Unir dos nodos extremos con un segmento nuevo</translation>
    </message>
    <message>
        <source>&amp;Break at Nodes</source>
        <translation>Se&amp;parar en los nodos</translation>
    </message>
    <message>
        <source>Split chains at the selected nodes, open closed ones</source>
        <translation>Partir las cadenas en los nodos seleccionados; abrir las cerradas</translation>
    </message>
    <message>
        <source>Make S&amp;traight in 15° Steps</source>
        <translation>Endere&amp;zar en pasos de 15°</translation>
    </message>
    <message>
        <source>Turn the selected segments to the nearest multiple of 15°</source>
        <translation>Girar los segmentos seleccionados al múltiplo de 15° más cercano</translation>
    </message>
    <message>
        <source>&amp;Next Node</source>
        <translation>Nodo si&amp;guiente</translation>
    </message>
    <message>
        <source>Select the next node</source>
        <translation>Seleccionar el nodo siguiente</translation>
    </message>
    <message>
        <source>Take the node tool and select an object first.</source>
        <translation>Primero tome la herramienta de nodos y seleccione un objeto.</translation>
    </message>
    <message>
        <source>&amp;Previous Node</source>
        <translation>Nodo &amp;anterior</translation>
    </message>
    <message>
        <source>Select the previous node</source>
        <translation>Seleccionar el nodo anterior</translation>
    </message>
    <message>
        <source>Rotate &amp;Left 15°</source>
        <translation>Girar 15° a la i&amp;zquierda</translation>
    </message>
    <message>
        <source>Turn the selection anticlockwise</source>
        <translation>Girar la selección en sentido antihorario</translation>
    </message>
    <message>
        <source>Rotate &amp;Right 15°</source>
        <translation>Girar 15° a la &amp;derecha</translation>
    </message>
    <message>
        <source>Turn the selection clockwise</source>
        <translation>Girar la selección en sentido horario</translation>
    </message>
    <message>
        <source>Rotate Left &amp;90°</source>
        <translation>Girar &amp;90° a la izquierda</translation>
    </message>
    <message>
        <source>Turn the selection a quarter anticlockwise</source>
        <translation>Girar la selección un cuarto de vuelta en sentido antihorario</translation>
    </message>
    <message>
        <source>Rotate Right 9&amp;0°</source>
        <translation>Girar 9&amp;0° a la derecha</translation>
    </message>
    <message>
        <source>Turn the selection a quarter clockwise</source>
        <translation>Girar la selección un cuarto de vuelta en sentido horario</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>Voltear en &amp;horizontal</translation>
    </message>
    <message>
        <source>Swap left and right; walls stay solid on the same side</source>
        <translation>Cambiar izquierda por derecha; los muros siguen sólidos por el mismo lado</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Voltear en &amp;vertical</translation>
    </message>
    <message>
        <source>Swap above and below; walls stay solid on the same side</source>
        <translation>Cambiar arriba por abajo; los muros siguen sólidos por el mismo lado</translation>
    </message>
    <message>
        <source>Re&amp;peat Last Transform</source>
        <translation>&amp;Repetir transformación</translation>
    </message>
    <message>
        <source>Move, turn, scale or copy the selection once more as it was done last</source>
        <translation>Mover, girar, escalar o copiar la selección otra vez como la última vez</translation>
    </message>
    <message>
        <source>&amp;Type Place and Size…</source>
        <translation>&amp;Escribir posición y tamaño…</translation>
    </message>
    <message>
        <source>Move, scale and turn the selection by numbers</source>
        <translation>Mover, escalar y girar la selección con números</translation>
    </message>
    <message>
        <source>L&amp;inear Array…</source>
        <translation>Repetición &amp;lineal…</translation>
    </message>
    <message>
        <source>Make copies of the selection in a row</source>
        <translation>Hacer copias de la selección en fila</translation>
    </message>
    <message>
        <source>R&amp;adial Array…</source>
        <translation>Repetición r&amp;adial…</translation>
    </message>
    <message>
        <source>Make copies of the selection round its pivot</source>
        <translation>Hacer copias de la selección alrededor de su pivote</translation>
    </message>
    <message>
        <source>Re&amp;verse Direction</source>
        <translation>Inver&amp;tir dirección</translation>
    </message>
    <message>
        <source>Make one-way walls solid from the other side</source>
        <translation>Hacer sólidos por el otro lado los muros de una cara</translation>
    </message>
    <message>
        <source>&amp;Bounding Boxes</source>
        <translation>Ca&amp;jas delimitadoras</translation>
    </message>
    <message>
        <source>&amp;Incircles</source>
        <translation>Círculos &amp;inscritos</translation>
    </message>
    <message>
        <source>Show the incircle of every polygon</source>
        <translation>Mostrar el círculo inscrito de cada polígono</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Velocidades</translation>
    </message>
    <message>
        <source>Show where every body would be in a second</source>
        <translation>Mostrar dónde estaría cada cuerpo dentro de un segundo</translation>
    </message>
    <message>
        <source>&amp;Orientations</source>
        <translation>&amp;Orientaciones</translation>
    </message>
    <message>
        <source>Show which way up every body is</source>
        <translation>Mostrar hacia dónde apunta cada cuerpo</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>&amp;Normales</translation>
    </message>
    <message>
        <source>&amp;All Off</source>
        <translation>Ocult&amp;ar todo</translation>
    </message>
    <message>
        <source>Hide all overlays</source>
        <translation>Ocultar todas las superposiciones</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>Eti&amp;quetas</translation>
    </message>
    <message>
        <source>Show names and colors of the tags of every object</source>
        <translation>Mostrar nombres y colores de las etiquetas de cada objeto</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Problemas</translation>
    </message>
    <message>
        <source>Mark the places of all problems of the level</source>
        <translation>Marcar los lugares de todos los problemas del nivel</translation>
    </message>
    <message>
        <source>Sho&amp;w What Collides</source>
        <translation>Mostrar con qué &amp;colisiona</translation>
    </message>
    <message>
        <source>Mark everything that the selection would collide with, by its tags</source>
        <translation>Marcar todo aquello con lo que la selección colisionaría, según sus etiquetas</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>&amp;Buscar…</translation>
    </message>
    <message>
        <source>Find objects by name, kind or tag in the outliner</source>
        <translation>Buscar objetos por nombre, tipo o etiqueta en el esquema</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Re&amp;nombrar…</translation>
    </message>
    <message>
        <source>Give the selected object another name, in the outliner</source>
        <translation>Dar otro nombre al objeto seleccionado, en el esquema</translation>
    </message>
    <message>
        <source>Level P&amp;roperties…</source>
        <translation>&amp;Propiedades del nivel…</translation>
    </message>
    <message>
        <source>Edit the name, rules and physics of the level itself</source>
        <translation>Editar el nombre, las reglas y la física del propio nivel</translation>
    </message>
    <message>
        <source>Compare &amp;With…</source>
        <translation>&amp;Comparar con…</translation>
    </message>
    <message>
        <source>Choose a level file and show what is different from it</source>
        <translation>Elegir un archivo de nivel y mostrar en qué difiere</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Jugar</translation>
    </message>
    <message>
        <source>Play a copy of the level, here and now</source>
        <translation>Jugar una copia del nivel, aquí y ahora</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Detener</translation>
    </message>
    <message>
        <source>Pa&amp;use</source>
        <translation>Pau&amp;sa</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>&amp;Fotograma siguiente</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Reiniciar</translation>
    </message>
    <message>
        <source>&amp;Snap to Grid</source>
        <translation>&amp;Ajustar a la cuadrícula</translation>
    </message>
    <message>
        <source>Let points land on the grid; Ctrl suspends it while it is held</source>
        <translation>Llevar los puntos a la cuadrícula; Ctrl lo suspende mientras se pulsa</translation>
    </message>
    <message>
        <source>&amp;Coarser Grid</source>
        <translation>Cuadrícula más &amp;gruesa</translation>
    </message>
    <message>
        <source>Go on to the next larger step of the grid</source>
        <translation>Pasar al siguiente paso mayor de la cuadrícula</translation>
    </message>
    <message>
        <source>&amp;Finer Grid</source>
        <translation>Cuadrícula más &amp;fina</translation>
    </message>
    <message>
        <source>Go on to the next smaller step of the grid</source>
        <translation>Pasar al siguiente paso menor de la cuadrícula</translation>
    </message>
    <message>
        <source>Snap to &amp;Objects</source>
        <translation>Ajustar a &amp;objetos</translation>
    </message>
    <message>
        <source>Let points land on what is in the level; Ctrl suspends it while it is held</source>
        <translation>Llevar los puntos a lo que hay en el nivel; Ctrl lo suspende mientras se pulsa</translation>
    </message>
    <message>
        <source>&amp;Vertices and Centers</source>
        <translation>&amp;Vértices y centros</translation>
    </message>
    <message>
        <source>Snap to the vertices of objects, and to the centers of circles</source>
        <translation>Ajustar a los vértices de los objetos y a los centros de los círculos</translation>
    </message>
    <message>
        <source>Only while snapping to objects is on.</source>
        <translation>Solo mientras el ajuste a objetos está activo.</translation>
    </message>
    <message>
        <source>&amp;Midpoints</source>
        <translation>Puntos &amp;medios</translation>
    </message>
    <message>
        <source>Snap to the middles of segments</source>
        <translation>Ajustar a los puntos medios de los segmentos</translation>
    </message>
    <message>
        <source>&amp;Intersections</source>
        <translation>&amp;Intersecciones</translation>
    </message>
    <message>
        <source>Snap to where edges and guides cross</source>
        <translation>Ajustar a los cruces de bordes y guías</translation>
    </message>
    <message>
        <source>&amp;Perpendiculars</source>
        <translation>Pe&amp;rpendiculares</translation>
    </message>
    <message>
        <source>Snap to where the way from the last point meets an edge at a right angle</source>
        <translation>Ajustar donde el camino desde el último punto llega a un borde en ángulo recto</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>Bor&amp;des</translation>
    </message>
    <message>
        <source>Snap to the edges of objects</source>
        <translation>Ajustar a los bordes de los objetos</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>G&amp;uías</translation>
    </message>
    <message>
        <source>Snap to guides</source>
        <translation>Ajustar a las guías</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>A&amp;lineación</translation>
    </message>
    <message>
        <source>Snap in line with the sides and middles of other objects</source>
        <translation>Ajustar en línea con los lados y centros de otros objetos</translation>
    </message>
    <message>
        <source>A&amp;ngles</source>
        <translation>Á&amp;ngulos</translation>
    </message>
    <message>
        <source>Snap to multiples of 15° from the last point; Shift keeps to them always</source>
        <translation>Ajustar a múltiplos de 15° desde el último punto; Mayús los mantiene siempre</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Seleccionar</translation>
    </message>
    <message>
        <source>Select and move objects</source>
        <translation>Seleccionar y mover objetos</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nodos</translation>
    </message>
    <message>
        <source>Move, insert and delete the nodes of selected objects</source>
        <translation>Mover, insertar y eliminar los nodos de los objetos seleccionados</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>Cuc&amp;hilla</translation>
    </message>
    <message>
        <source>Cut walls, lines and polygons along a line</source>
        <translation>Cortar muros, líneas y polígonos a lo largo de una línea</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>Measure lengths and angles</source>
        <translation>Medir longitudes y ángulos</translation>
    </message>
    <message>
        <source>One-Way &amp;Wall</source>
        <translation>Mu&amp;ro de una cara</translation>
    </message>
    <message>
        <source>Draw walls that are solid from one side</source>
        <translation>Dibujar muros sólidos por un lado</translation>
    </message>
    <message>
        <source>Two-Way &amp;Line</source>
        <translation>&amp;Línea de dos caras</translation>
    </message>
    <message>
        <source>Draw walls that are solid from both sides</source>
        <translation>Dibujar muros sólidos por ambos lados</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Polígono</translation>
    </message>
    <message>
        <source>Draw a solid polygon</source>
        <translation>Dibujar un polígono sólido</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rec&amp;tángulo</translation>
    </message>
    <message>
        <source>Draw a solid rectangle</source>
        <translation>Dibujar un rectángulo sólido</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Círculo</translation>
    </message>
    <message>
        <source>Draw a circle from its center</source>
        <translation>Dibujar un círculo desde su centro</translation>
    </message>
    <message>
        <source>Moving &amp;Body</source>
        <translation>Cuerpo móv&amp;il</translation>
    </message>
    <message>
        <source>Draw a body that moves as it is told, and its velocity</source>
        <translation>Dibujar un cuerpo que se mueve como se le indica, y su velocidad</translation>
    </message>
    <message>
        <source>C&amp;onnector</source>
        <translation>Con&amp;ector</translation>
    </message>
    <message>
        <source>Join two bodies by a spring or rope</source>
        <translation>Unir dos cuerpos con un muelle o una cuerda</translation>
    </message>
    <message>
        <source>S&amp;hip</source>
        <translation>Na&amp;ve</translation>
    </message>
    <message>
        <source>Place the ship; drag to turn it</source>
        <translation>Colocar la nave; arrastre para girarla</translation>
    </message>
    <message>
        <source>Pa&amp;yload</source>
        <translation>Car&amp;ga</translation>
    </message>
    <message>
        <source>Place the payload</source>
        <translation>Colocar la carga</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>Met&amp;a</translation>
    </message>
    <message>
        <source>Draw the line that the payload has to cross</source>
        <translation>Dibujar la línea que la carga tiene que cruzar</translation>
    </message>
    <message>
        <source>Pl&amp;ace Ship, Payload, Finish</source>
        <translation>C&amp;olocar nave, carga, meta</translation>
    </message>
    <message>
        <source>&amp;Guide…</source>
        <translation>G&amp;uía…</translation>
    </message>
    <message>
        <source>Add a guide at the pointer and type where it is</source>
        <translation>Añadir una guía en el puntero y escribir su posición</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>Ac&amp;ercar</translation>
    </message>
    <message>
        <source>Show less of the level, larger</source>
        <translation>Mostrar menos del nivel, más grande</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ale&amp;jar</translation>
    </message>
    <message>
        <source>Show more of the level, smaller</source>
        <translation>Mostrar más del nivel, más pequeño</translation>
    </message>
    <message>
        <source>Original Si&amp;ze</source>
        <translation>Tamaño &amp;original</translation>
    </message>
    <message>
        <source>Show the level as large as in the game</source>
        <translation>Mostrar el nivel tan grande como en el juego</translation>
    </message>
    <message>
        <source>&amp;Fit Level</source>
        <translation>Encajar ni&amp;vel</translation>
    </message>
    <message>
        <source>Show the whole level</source>
        <translation>Mostrar el nivel entero</translation>
    </message>
    <message>
        <source>&amp;Center Selection</source>
        <translation>Centrar &amp;selección</translation>
    </message>
    <message>
        <source>Bring the selection to the middle of the view</source>
        <translation>Llevar la selección al centro de la vista</translation>
    </message>
    <message>
        <source>Fra&amp;me Selection</source>
        <translation>E&amp;ncuadrar selección</translation>
    </message>
    <message>
        <source>Show the selection as large as fits</source>
        <translation>Mostrar la selección tan grande como quepa</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Cu&amp;adrícula</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Mostrar la cuadrícula</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>&amp;Reglas</translation>
    </message>
    <message>
        <source>Show the rulers, out of which guides are dragged</source>
        <translation>Mostrar las reglas, de las que se sacan las guías</translation>
    </message>
    <message>
        <source>Guid&amp;es</source>
        <translation>&amp;Guías</translation>
    </message>
    <message>
        <source>Show the guides; what is hidden is neither taken nor snapped to</source>
        <translation>Mostrar las guías; las ocultas ni se toman ni sirven de ajuste</translation>
    </message>
    <message>
        <source>&amp;Delete All Guides</source>
        <translation>Eliminar to&amp;das las guías</translation>
    </message>
    <message>
        <source>Take all guides out of the level</source>
        <translation>Quitar todas las guías del nivel</translation>
    </message>
    <message>
        <source>The level has no guides.</source>
        <translation>El nivel no tiene guías.</translation>
    </message>
    <message>
        <source>Hide &amp;All</source>
        <translation>&amp;Ocultar todo</translation>
    </message>
    <message>
        <source>Put all panels out of the way, and back as they were</source>
        <translation>Quitar de en medio todos los paneles, y devolverlos como estaban</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Pantalla completa</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Usar toda la pantalla</translation>
    </message>
    <message>
        <source>Like &amp;the Desktop</source>
        <translation>Como el &amp;escritorio</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is, and changing with it</source>
        <translation>Claro u oscuro según el escritorio, y cambiando con él</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Claro</translation>
    </message>
    <message>
        <source>Light panels and a white drawing board</source>
        <translation>Paneles claros y lienzo blanco</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Oscuro</translation>
    </message>
    <message>
        <source>Dark panels and a drawing board as dark as space</source>
        <translation>Paneles oscuros y un lienzo oscuro como el espacio</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Nueva ve&amp;ntana</translation>
    </message>
    <message>
        <source>Start an empty level in another window</source>
        <translation>Empezar un nivel vacío en otra ventana</translation>
    </message>
    <message>
        <source>New &amp;View</source>
        <translation>Nueva v&amp;ista</translation>
    </message>
    <message>
        <source>Show this level in a second window, at another place or another size</source>
        <translation>Mostrar este nivel en una segunda ventana, en otro lugar o con otro tamaño</translation>
    </message>
    <message>
        <source>&amp;Next Window</source>
        <translation>Ventana &amp;siguiente</translation>
    </message>
    <message>
        <source>Go on in the next window of the program</source>
        <translation>Seguir en la siguiente ventana del programa</translation>
    </message>
    <message>
        <source>Welcome &amp;Page</source>
        <translation>Página de bien&amp;venida</translation>
    </message>
    <message>
        <source>Choose among recent levels and those that come with the program</source>
        <translation>Elegir entre los niveles recientes y los que vienen con el programa</translation>
    </message>
    <message>
        <source>&amp;Reopen Windows at Start</source>
        <translation>&amp;Reabrir ventanas al inicio</translation>
    </message>
    <message>
        <source>Begin with the levels that were open when the program was left</source>
        <translation>Empezar con los niveles que estaban abiertos al salir del programa</translation>
    </message>
    <message>
        <source>Open a level first.</source>
        <translation>Abra primero un nivel.</translation>
    </message>
    <message>
        <source>No level has been closed yet.</source>
        <translation>Aún no se ha cerrado ningún nivel.</translation>
    </message>
    <message>
        <source>The level has no file yet.</source>
        <translation>El nivel aún no tiene archivo.</translation>
    </message>
    <message>
        <source>Go to a problem first for which there is a fix.</source>
        <translation>Vaya primero a un problema que tenga arreglo.</translation>
    </message>
    <message>
        <source>There is no problem that could be cured without asking.</source>
        <translation>No hay ningún problema que se pueda arreglar sin preguntar.</translation>
    </message>
    <message>
        <source>Go to a problem first.</source>
        <translation>Vaya primero a un problema.</translation>
    </message>
    <message>
        <source>The grid is as coarse as it gets.</source>
        <translation>La cuadrícula no puede ser más gruesa.</translation>
    </message>
    <message>
        <source>The grid is as fine as it gets.</source>
        <translation>La cuadrícula no puede ser más fina.</translation>
    </message>
    <message>
        <source>This window stands alone.</source>
        <translation>Esta ventana está sola.</translation>
    </message>
    <message>
        <source>There is no other window.</source>
        <translation>No hay ninguna otra ventana.</translation>
    </message>
    <message>
        <source>Show the bounding box of every body, and that of the broad phase</source>
        <translation>Mostrar la caja delimitadora de cada cuerpo y la de la fase amplia</translation>
    </message>
    <message>
        <source>Show the free side of every wall, and the solid band behind it</source>
        <translation>Mostrar el lado libre de cada muro y la franja sólida que hay detrás</translation>
    </message>
    <message>
        <source>&amp;Quadtrees</source>
        <translation>Q&amp;uadtrees</translation>
    </message>
    <message>
        <source>Show the cells in which collisions are looked for, and what they hold</source>
        <translation>Mostrar las celdas en que se buscan colisiones y lo que contienen</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>Con&amp;tactos</translation>
    </message>
    <message>
        <source>Show where bodies touch, and the forces between them</source>
        <translation>Mostrar dónde se tocan los cuerpos y las fuerzas entre ellos</translation>
    </message>
    <message>
        <source>T&amp;ension</source>
        <translation>T&amp;ensión</translation>
    </message>
    <message>
        <source>Show how much every rope and connector pulls</source>
        <translation>Mostrar cuánto tira cada cuerda y cada conector</translation>
    </message>
    <message>
        <source>T&amp;rails</source>
        <translation>Tra&amp;zas</translation>
    </message>
    <message>
        <source>Show the way that every body has gone, or will go at first</source>
        <translation>Mostrar el camino que cada cuerpo ha recorrido o recorrerá al principio</translation>
    </message>
    <message>
        <source>Centers of &amp;Mass</source>
        <translation>Centros de &amp;masa</translation>
    </message>
    <message>
        <source>Show the center of mass of every body</source>
        <translation>Mostrar el centro de masa de cada cuerpo</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Nombres</translation>
    </message>
    <message>
        <source>Show the name of every object that has one</source>
        <translation>Mostrar el nombre de cada objeto que lo tenga</translation>
    </message>
    <message>
        <source>I&amp;slands and Sleep</source>
        <translation>Islas &amp;y sueño</translation>
    </message>
    <message>
        <source>Show which bodies may push each other, and which ones sleep</source>
        <translation>Mostrar qué cuerpos pueden empujarse y cuáles duermen</translation>
    </message>
    <message>
        <source>Ris&amp;k of Passing Through</source>
        <translation>&amp;Riesgo de atravesar</translation>
    </message>
    <message>
        <source>Show how far through each wall one iteration may carry what approaches it</source>
        <translation>Mostrar hasta dónde puede atravesar cada muro, en una iteración, lo que se le acerca</translation>
    </message>
    <message>
        <source>Reach o&amp;f the Ship</source>
        <translation>Alcance &amp;de la nave</translation>
    </message>
    <message>
        <source>Show where the ship, and the payload on its rope, can be in the next seconds: from its start, or from where it is in a run that is paused</source>
        <translation>Mostrar dónde pueden estar la nave, y la carga en su cuerda, en los próximos segundos: desde su salida, o desde donde está en una ejecución en pausa</translation>
    </message>
    <message>
        <source>Reach a Second Longer</source>
        <translation>Alargar el alcance un segundo</translation>
    </message>
    <message>
        <source>Look a second further ahead, up to five</source>
        <translation>Mirar un segundo más adelante, hasta cinco</translation>
    </message>
    <message>
        <source>Reach a Second Shorter</source>
        <translation>Acortar el alcance un segundo</translation>
    </message>
    <message>
        <source>Look less far ahead, down to one second</source>
        <translation>Mirar menos adelante, hasta un solo segundo</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Leyenda</translation>
    </message>
    <message>
        <source>Explain the colors of the overlays that are on, in a corner of the canvas</source>
        <translation>Explicar los colores de las superposiciones visibles en una esquina del lienzo</translation>
    </message>
    <message>
        <source>Color-Blind-Safe Colors</source>
        <translation>Colores para daltónicos</translation>
    </message>
    <message>
        <source>Draw the overlays in the colors of Okabe and Ito, which everybody tells apart</source>
        <translation>Dibujar las superposiciones con los colores de Okabe e Ito, que todo el mundo distingue</translation>
    </message>
    <message>
        <source>Forget Own Colors</source>
        <translation>Olvidar colores propios</translation>
    </message>
    <message>
        <source>Give all overlays the colors of the set again</source>
        <translation>Devolver a todas las superposiciones los colores del conjunto</translation>
    </message>
    <message>
        <source>No overlay has a color of your own: click one in the legend.</source>
        <translation>Ninguna superposición tiene un color propio: haga clic en una en la leyenda.</translation>
    </message>
    <message>
        <source>S&amp;imulate</source>
        <translation>S&amp;imular</translation>
    </message>
    <message>
        <source>Let the bodies of the level move in place, and go on editing beside</source>
        <translation>Dejar que los cuerpos del nivel se muevan en su sitio y seguir editando a la vez</translation>
    </message>
    <message>
        <source>The level runs already.</source>
        <translation>El nivel ya está en marcha.</translation>
    </message>
    <message>
        <source>Play fr&amp;om Pointer</source>
        <translation>Jugar desde el &amp;puntero</translation>
    </message>
    <message>
        <source>Play a copy of the level in which the ship starts where the pointer is</source>
        <translation>Jugar una copia del nivel en la que la nave empieza donde está el puntero</translation>
    </message>
    <message>
        <source>Go back to the drawing board</source>
        <translation>Volver al lienzo</translation>
    </message>
    <message>
        <source>Hold what runs, or let it go on</source>
        <translation>Pausar la ejecución o continuarla</translation>
    </message>
    <message>
        <source>Hold what runs and advance it by one update</source>
        <translation>Pausar la ejecución y avanzarla una actualización</translation>
    </message>
    <message>
        <source>Run the level from its beginning</source>
        <translation>Ejecutar el nivel desde el principio</translation>
    </message>
    <message>
        <source>Pre&amp;vious Frame</source>
        <translation>Fotograma &amp;anterior</translation>
    </message>
    <message>
        <source>Hold what runs and go back by one update</source>
        <translation>Pausar la ejecución y retroceder una actualización</translation>
    </message>
    <message>
        <source>Next I&amp;teration</source>
        <translation>I&amp;teración siguiente</translation>
    </message>
    <message>
        <source>Hold what runs and look into the next update, one iteration further</source>
        <translation>Pausar la ejecución y mirar dentro de la actualización siguiente, una iteración más allá</translation>
    </message>
    <message>
        <source>To the &amp;Beginning</source>
        <translation>Al prin&amp;cipio</translation>
    </message>
    <message>
        <source>Hold what runs and go back as far as it is kept</source>
        <translation>Pausar la ejecución y retroceder hasta donde se conserva</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Al fi&amp;nal</translation>
    </message>
    <message>
        <source>Hold what runs and show its last moment</source>
        <translation>Pausar la ejecución y mostrar su último momento</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Más &amp;lento</translation>
    </message>
    <message>
        <source>Let time run half as fast; [ does so on the canvas</source>
        <translation>Hacer que el tiempo vaya a la mitad de velocidad; [ lo hace en el lienzo</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>&amp;Más rápido</translation>
    </message>
    <message>
        <source>Let time run twice as fast; ] does so on the canvas</source>
        <translation>Hacer que el tiempo vaya el doble de rápido; ] lo hace en el lienzo</translation>
    </message>
    <message>
        <source>&amp;Follow the Ship</source>
        <translation>Seguir a la na&amp;ve</translation>
    </message>
    <message>
        <source>Let the view go with the ship again, after it has been moved</source>
        <translation>Hacer que la vista siga otra vez a la nave después de haberla movido</translation>
    </message>
    <message>
        <source>Only in a game is there a ship to follow.</source>
        <translation>Solo en una partida hay una nave a la que seguir.</translation>
    </message>
    <message>
        <source>Save Fli&amp;ght…</source>
        <translation>&amp;Guardar vuelo…</translation>
    </message>
    <message>
        <source>Write what has been flown into a file that can be dropped on a window</source>
        <translation>Guardar lo volado en un archivo que se puede soltar sobre una ventana</translation>
    </message>
    <message>
        <source>Copy &amp;Bug Capsule</source>
        <translation>Copiar la cápsula de &amp;error</translation>
    </message>
    <message>
        <source>Copy the level and the run up to this moment as text, for a mail or an issue; pasted into a window, it opens at the same moment</source>
        <translation>Copiar el nivel y la ejecución hasta este momento como texto, para un correo o un informe de error; pegado en una ventana, se abre en el mismo momento</translation>
    </message>
    <message>
        <source>In a game only while its panels are shown.</source>
        <translation>En una partida, solo mientras se muestran sus paneles.</translation>
    </message>
    <message>
        <source>Overlay Colors…</source>
        <translation>Colores de las superposiciones…</translation>
    </message>
    <message>
        <source>Choose the set of colors of the overlays, and colors of your own for each</source>
        <translation>Elegir el juego de colores de las superposiciones y colores propios para cada una</translation>
    </message>
    <message>
        <source>Wa&amp;ys of a Run</source>
        <translation>Trayecto&amp;s de una ejecución</translation>
    </message>
    <message>
        <source>Show the ways of the last minute where a run is held, and those of futures given up</source>
        <translation>Mostrar los trayectos del último minuto de una ejecución detenida y los de futuros abandonados</translation>
    </message>
    <message>
        <source>What is selected is locked.</source>
        <translation>Lo seleccionado está bloqueado.</translation>
    </message>
    <message>
        <source>Ship, payload and finish exist once, and connectors are copied with their two bodies.</source>
        <translation>La nave, la carga y la meta existen una sola vez, y los conectores se copian con sus dos cuerpos.</translation>
    </message>
    <message>
        <source>Select a wall or a line first.</source>
        <translation>Seleccione primero un muro o una línea.</translation>
    </message>
    <message>
        <source>Select a group first.</source>
        <translation>Seleccione primero un grupo.</translation>
    </message>
    <message>
        <source>What is selected has no nodes.</source>
        <translation>Lo seleccionado no tiene nodos.</translation>
    </message>
    <message>
        <source>“%1” changes nothing here.</source>
        <translation>«%1» no cambia nada aquí.</translation>
    </message>
    <message>
        <source>Put the selection into a new layer, or make an empty one, and type its name</source>
        <translation>Poner la selección en una capa nueva, o crear una vacía, y escribir su nombre</translation>
    </message>
    <message>
        <source>Insert Node &amp;Here</source>
        <translation>Insertar un nodo aqu&amp;í</translation>
    </message>
    <message>
        <source>Insert a node where the pointer is at an edge of the selection</source>
        <translation>Insertar un nodo donde el puntero está en un borde de la selección</translation>
    </message>
    <message>
        <source>Not while the level runs.</source>
        <translation>No mientras el nivel está en marcha.</translation>
    </message>
    <message>
        <source>Place ship, payload or finish, first what the level lacks; again for the next of them</source>
        <translation>Colocar nave, carga o meta, primero lo que falta en el nivel; otra vez para el siguiente</translation>
    </message>
</context>
<context>
    <name>BugCapsule</name>
    <message>
        <source>Another bug capsule is still being worked on.</source>
        <translation>Todavía se está trabajando en otra cápsula de error.</translation>
    </message>
    <message>
        <source>A bug capsule of %1 is on the clipboard. Paste it into a mail or an issue, or into a window of this program.</source>
        <translation>Una cápsula de error de %1 está en el portapapeles. Péguela en un correo, en un informe de error o en una ventana de este programa.</translation>
    </message>
    <message>
        <source>The run comes out otherwise here than where the bug capsule was made, with %1 on %2.</source>
        <translation>La ejecución resulta aquí distinta de la de donde se creó la cápsula de error, con %1 en %2.</translation>
    </message>
    <message>
        <source>The bug capsule is being read…</source>
        <translation>Se está leyendo la cápsula de error…</translation>
    </message>
    <message>
        <source>The bug capsule</source>
        <translation>La cápsula de error</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
</context>
<context>
    <name>Compared</name>
    <message>
        <source>none</source>
        <translation>nada</translation>
    </message>
    <message>
        <source>all</source>
        <translation>todo</translation>
    </message>
    <message>
        <source>all but %1</source>
        <translation>todo menos %1</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>sí</translation>
    </message>
    <message>
        <source>no</source>
        <translation>no</translation>
    </message>
    <message>
        <source>Level: %1</source>
        <translation>Nivel: %1</translation>
    </message>
    <message>
        <source>Guide %1: added</source>
        <translation>Guía %1: añadida</translation>
    </message>
    <message>
        <source>Guide %1: removed</source>
        <translation>Guía %1: eliminada</translation>
    </message>
    <message>
        <source>Level: fields that this program does not know</source>
        <translation>Nivel: campos que este programa no conoce</translation>
    </message>
    <message>
        <source>Level: other problems are hidden</source>
        <translation>Nivel: hay otros problemas ocultos</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Tag “%1”: added</source>
        <translation>Etiqueta «%1»: añadida</translation>
    </message>
    <message>
        <source>Tag “%1”: removed</source>
        <translation>Etiqueta «%1»: eliminada</translation>
    </message>
    <message>
        <source>Tag “%1”: renamed to “%2”</source>
        <translation>Etiqueta «%1»: renombrada a «%2»</translation>
    </message>
    <message>
        <source>Tag “%1”: color %2 → %3</source>
        <translation>Etiqueta «%1»: color %2 → %3</translation>
    </message>
    <message>
        <source>added</source>
        <translation>añadido</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>eliminado</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>antes %1</translation>
    </message>
    <message>
        <source>shape moved</source>
        <translation>forma movida</translation>
    </message>
    <message>
        <source>shape changed</source>
        <translation>forma cambiada</translation>
    </message>
    <message>
        <source>shape changed, points %1 → %2</source>
        <translation>forma cambiada, puntos %1 → %2</translation>
    </message>
    <message>
        <source>drawn in another place</source>
        <translation>dibujado en otro orden</translation>
    </message>
    <message>
        <source>fields that this program does not know</source>
        <translation>campos que este programa no conoce</translation>
    </message>
    <message>
        <source>The level</source>
        <translation>El nivel</translation>
    </message>
    <message>
        <source>%1: both sides changed “%2”.</source>
        <translation>%1: ambos lados cambiaron «%2».</translation>
    </message>
    <message>
        <source>%1: both sides made something else of it.</source>
        <translation>%1: cada lado lo convirtió en algo distinto.</translation>
    </message>
    <message>
        <source>%1: both sides added another object under the key %2.</source>
        <translation>%1: ambos lados añadieron otro objeto con la clave %2.</translation>
    </message>
    <message>
        <source>%1: our side removed it, their side changed or needs it. It stays.</source>
        <translation>%1: nuestro lado lo eliminó; el otro lo cambió o lo necesita. Se queda.</translation>
    </message>
    <message>
        <source>%1: their side removed it, our side changed or needs it. It stays.</source>
        <translation>%1: el otro lado lo eliminó; el nuestro lo cambió o lo necesita. Se queda.</translation>
    </message>
    <message>
        <source>%1: groups would be in each other. It stays in the group that our side has put it in.</source>
        <translation>%1: unos grupos estarían dentro de otros. Se queda en el grupo en que lo puso nuestro lado.</translation>
    </message>
    <message>
        <source>%1: both sides changed the order of drawing.</source>
        <translation>%1: ambos lados cambiaron el orden de dibujo.</translation>
    </message>
    <message>
        <source>There is no room for the tag “%1” of their side among the 32 tags.</source>
        <translation>La etiqueta «%1» del otro lado no cabe entre las 32 etiquetas.</translation>
    </message>
    <message>
        <source>Guides: in another order</source>
        <translation>Guías: en otro orden</translation>
    </message>
    <message>
        <source>at %1; %2</source>
        <translation>en %1; %2</translation>
    </message>
</context>
<context>
    <name>CrashWords</name>
    <message>
        <source>The ship hit the payload.</source>
        <translation>La nave ha chocado con la carga.</translation>
    </message>
    <message>
        <source>The ship hit “%1”.</source>
        <translation>La nave ha chocado con «%1».</translation>
    </message>
    <message>
        <source>The payload hit “%1”.</source>
        <translation>La carga ha chocado con «%1».</translation>
    </message>
    <message>
        <source>The ship hit something tagged “%1”.</source>
        <translation>La nave ha chocado con algo con la etiqueta «%1».</translation>
    </message>
    <message>
        <source>The payload hit something tagged “%1”.</source>
        <translation>La carga ha chocado con algo con la etiqueta «%1».</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a flight in the level “%2”, which is neither open nor beside it. Open the level and drop the flight on it.</source>
        <translation>%1 es un vuelo en el nivel «%2», que no está abierto ni junto al vuelo. Abra el nivel y suelte el vuelo sobre él.</translation>
    </message>
    <message>
        <source>The level has been changed since the flight was recorded, which may therefore end otherwise.</source>
        <translation>El nivel ha cambiado desde que se grabó el vuelo, así que puede terminar de otra forma.</translation>
    </message>
    <message>
        <source>Files of other programs are imported one at a time, as each is looked at first: of these it is %1.</source>
        <translation>Los archivos de otros programas se importan de uno en uno, ya que cada uno se revisa antes: de estos es %1.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the flight.</source>
        <translation>No hay memoria suficiente para leer el vuelo.</translation>
    </message>
    <message>
        <source>%1 is a simulation of the level “%2”, which is neither open nor beside it. Open the level and drop the simulation on it.</source>
        <translation>%1 es una simulación del nivel «%2», que no está abierto ni junto a ella. Abra el nivel y suelte la simulación en él.</translation>
    </message>
    <message>
        <source>The level has been changed since the simulation was recorded, which may therefore go otherwise.</source>
        <translation>El nivel ha cambiado desde que se grabó la simulación, que puede por ello transcurrir de otro modo.</translation>
    </message>
</context>
<context>
    <name>Explain</name>
    <message>
        <source>Debris</source>
        <translation>Escombros</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Fuerzas</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Thrust and steering</source>
        <translation>Propulsión y dirección</translation>
    </message>
    <message>
        <source>Pulled by the mouse</source>
        <translation>Arrastre del ratón</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Conectores</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>felt, without a force</source>
        <translation>se percibe, sin fuerza</translation>
    </message>
    <message>
        <source>%1, of which friction %2</source>
        <translation>%1, de ello fricción %2</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguno</translation>
    </message>
    <message>
        <source>Tags touched</source>
        <translation>Etiquetas tocadas</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Gira</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Energía cinética</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>Energía potencial</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Momento lineal</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Momento angular propio</translation>
    </message>
    <message>
        <source>Angular momentum</source>
        <translation>Momento angular</translation>
    </message>
    <message>
        <source>Sleeps</source>
        <translation>Duerme</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tracción</translation>
    </message>
    <message>
        <source>Distance of its ends</source>
        <translation>Distancia entre extremos</translation>
    </message>
    <message>
        <source>Natural length</source>
        <translation>Longitud natural</translation>
    </message>
    <message>
        <source>Pushes with</source>
        <translation>Empuja con</translation>
    </message>
    <message>
        <source>Pulls with</source>
        <translation>Tira con</translation>
    </message>
    <message>
        <source>Elastic energy</source>
        <translation>Energía elástica</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Entre</translation>
    </message>
    <message>
        <source>All bodies</source>
        <translation>Todos los cuerpos</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>Energía total</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>There is not enough memory to open the file.</source>
        <translation>No hay memoria suficiente para abrir el archivo.</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>Leyendo %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>SpaceTow levels (*.json);;All files (*)</source>
        <translation>Niveles de SpaceTow (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Cambios sin guardar</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>¿Guardar los cambios de «%1»?</translation>
    </message>
    <message>
        <source>If you discard them, they are lost.</source>
        <translation>Si los descarta, se pierden.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Descartar</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>The example</source>
        <translation>El ejemplo</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>Open level</source>
        <translation>Abrir nivel</translation>
    </message>
    <message>
        <source>Save level as</source>
        <translation>Guardar nivel como</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sin título</translation>
    </message>
    <message>
        <source>level</source>
        <translation>nivel</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>No se puede abrir %1.</translation>
    </message>
    <message>
        <source>%1 was opened, but:</source>
        <translation>Se ha abierto %1, pero:</translation>
    </message>
    <message>
        <source>Nothing is lost: your work is still here. Save it elsewhere?</source>
        <translation>No se ha perdido nada: su trabajo sigue aquí. ¿Guardarlo en otro sitio?</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>What was kept of %1 cannot be read.</source>
        <translation>No se puede leer lo que se conservó de %1.</translation>
    </message>
    <message>
        <source>Open Newest Backup</source>
        <translation>Abrir la copia más reciente</translation>
    </message>
    <message>
        <source>This is the newest backup of %1. The file stays as it is until you save.</source>
        <translation>Esta es la copia de seguridad más reciente de %1. El archivo no cambia hasta que usted guarde.</translation>
    </message>
    <message>
        <source>This backup cannot be opened.</source>
        <translation>No se puede abrir esta copia de seguridad.</translation>
    </message>
    <message>
        <source>%1 is saved, but of the version before no backup could be made:</source>
        <translation>%1 se ha guardado, pero no se pudo hacer una copia de seguridad de la versión anterior:</translation>
    </message>
    <message>
        <source>Compare with level</source>
        <translation>Comparar con un nivel</translation>
    </message>
</context>
<context>
    <name>FlightFile</name>
    <message>
        <source>The flight has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>El vuelo se guardó como %1. Suelte el archivo sobre una ventana para volver a verlo.</translation>
    </message>
    <message>
        <source>The simulation has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>La simulación se guardó como %1. Suelte el archivo sobre una ventana para volver a verla.</translation>
    </message>
    <message>
        <source>It ends after %1 of %2 updates: a file holds no more.</source>
        <translation>Termina tras %1 de %2 actualizaciones: un archivo no contiene más.</translation>
    </message>
    <message>
        <source>Another recording is still being saved.</source>
        <translation>Otra grabación aún se está guardando.</translation>
    </message>
</context>
<context>
    <name>FlightsPanel</name>
    <message>
        <source>wins after %1 s, with %2 s of thrust</source>
        <translation>gana tras %1 s, con %2 s de propulsión</translation>
    </message>
    <message>
        <source>is being flown…</source>
        <translation>en vuelo…</translation>
    </message>
    <message>
        <source>still wins, after %1 s</source>
        <translation>sigue ganando, a los %1 s</translation>
    </message>
    <message>
        <source>still wins, now after %1 s; before after %2 s</source>
        <translation>sigue ganando, ahora a los %1 s; antes a los %2 s</translation>
    </message>
    <message>
        <source>crashed before, wins now after %1 s</source>
        <translation>antes se estrellaba, ahora gana a los %1 s</translation>
    </message>
    <message>
        <source>was not won before, wins now after %1 s</source>
        <translation>antes no se ganaba, ahora gana a los %1 s</translation>
    </message>
    <message>
        <source>still crashes at %1, after %2 s</source>
        <translation>sigue estrellándose en %1, a los %2 s</translation>
    </message>
    <message>
        <source>still crashes, now at %1, after %2 s; before after %3 s</source>
        <translation>sigue estrellándose, ahora en %1, a los %2 s; antes a los %3 s</translation>
    </message>
    <message>
        <source>won before, crashes now at %1, after %2 s</source>
        <translation>antes ganaba, ahora se estrella en %1, a los %2 s</translation>
    </message>
    <message>
        <source>crashes now, at %1, after %2 s</source>
        <translation>ahora se estrella, en %1, a los %2 s</translation>
    </message>
    <message>
        <source>crashes at %1, after %2 s</source>
        <translation>se estrella en %1, a los %2 s</translation>
    </message>
    <message>
        <source>won before, now there is no ship</source>
        <translation>antes ganaba, ahora no hay nave</translation>
    </message>
    <message>
        <source>runs to its end</source>
        <translation>llega hasta su final</translation>
    </message>
    <message>
        <source>is still under way at its end, at %1</source>
        <translation>sigue en camino al final, en %1</translation>
    </message>
    <message>
        <source>is still under way at its end, now at %1</source>
        <translation>sigue en camino al final, ahora en %1</translation>
    </message>
    <message>
        <source>won before, now is under way at its end, at %1</source>
        <translation>antes ganaba, ahora está en camino al final, en %1</translation>
    </message>
    <message>
        <source>crashed before, now is under way at its end, at %1</source>
        <translation>antes se estrellaba, ahora está en camino al final, en %1</translation>
    </message>
    <message>
        <source>is under way at its end, at %1</source>
        <translation>está en camino al final, en %1</translation>
    </message>
    <message>
        <source>cannot be flown: too many bodies lie in the same place. Move them apart.</source>
        <translation>no se puede volar: hay demasiados cuerpos en el mismo lugar. Sepárelos.</translation>
    </message>
    <message>
        <source>is a simulation of %1 s</source>
        <translation>es una simulación de %1 s</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>no se puede leer: %1</translation>
    </message>
</context>
<context>
    <name>Forces</name>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>Aplicada</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Conectores</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
</context>
<context>
    <name>Grab</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
</context>
<context>
    <name>Hud</name>
    <message>
        <source>Ready</source>
        <translation>A punto</translation>
    </message>
    <message>
        <source>Press a direction to start</source>
        <translation>Pulse una dirección para empezar</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Choque</translation>
    </message>
    <message>
        <source>Press any key to try again</source>
        <translation>Pulse una tecla para volver a intentarlo</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Fin del juego</translation>
    </message>
    <message>
        <source>No life is left. Press any key to start the level over</source>
        <translation>No quedan vidas. Pulse una tecla para empezar el nivel de nuevo</translation>
    </message>
    <message>
        <source>You made it!</source>
        <translation>¡Conseguido!</translation>
    </message>
    <message>
        <source>Lives %1</source>
        <translation>Vidas %1</translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation>Tiempo %1</translation>
    </message>
    <message>
        <source>Fuel used %1 s</source>
        <translation>Combustible %1 s</translation>
    </message>
    <message>
        <source>Gravity is upside down!</source>
        <translation>¡La gravedad está al revés!</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>menú</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a key and what it does</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The payload is home.</source>
        <translation>La carga está en casa.</translation>
    </message>
    <message>
        <source>fly again</source>
        <translation>volar otra vez</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>seguir</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>un paso</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>tow</source>
        <translation>remolcar</translation>
    </message>
    <message>
        <source>In range.</source>
        <translation>Al alcance.</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>girar</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>empuje</translation>
    </message>
    <message>
        <source>Take the payload in tow and carry it across the finish.</source>
        <translation>Remolque la carga y llévela al otro lado de la meta.</translation>
    </message>
    <message>
        <source>Ship and payload are lost.</source>
        <translation>La nave y la carga se han perdido.</translation>
    </message>
    <message>
        <source>The ship is lost.</source>
        <translation>La nave se ha perdido.</translation>
    </message>
    <message>
        <source>The payload is lost.</source>
        <translation>La carga se ha perdido.</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Static</source>
        <translation>Estático</translation>
    </message>
    <message>
        <source>Kinematic</source>
        <translation>Cinemático</translation>
    </message>
    <message>
        <source>Dynamic</source>
        <translation>Dinámico</translation>
    </message>
    <message>
        <source>No tension</source>
        <translation>Sin tensión</translation>
    </message>
    <message>
        <source>Unlimited</source>
        <translation>Sin límite</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Recortada</translation>
    </message>
    <message>
        <source>Tanh</source>
        <translation>Tanh</translation>
    </message>
    <message>
        <source>Partial tanh</source>
        <translation>Tanh parcial</translation>
    </message>
    <message>
        <source>General</source>
        <translation>General</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Posición</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Materia</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Conector</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Colisiones</translation>
    </message>
    <message>
        <source>Rules of the game</source>
        <translation>Reglas del juego</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Física</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>For people; several objects may share one</source>
        <translation>Para las personas; varios objetos pueden compartirlo</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey forces</source>
        <translation>Los cuerpos estáticos nunca se mueven, los cinemáticos se mueven como se les indica y nada los empuja, los dinámicos obedecen a las fuerzas</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Name or key of the group that it is in; nothing for none</source>
        <translation>Nombre o clave del grupo en que está; vacío: en ninguno</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Of the group&apos;s mark and of what is selected in it</source>
        <translation>De la marca del grupo y de lo seleccionado en él</translation>
    </message>
    <message>
        <source>Layer: a group at the top</source>
        <translation>Capa: un grupo en lo más alto</translation>
    </message>
    <message>
        <source>Visible in the editor</source>
        <translation>Visible en el editor</translation>
    </message>
    <message>
        <source>Locked: cannot be picked or moved</source>
        <translation>Bloqueado: no se puede tomar ni mover</translation>
    </message>
    <message>
        <source>Where the origin of the object is</source>
        <translation>Dónde está el origen del objeto</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Anticlockwise. Plain numbers are degrees; write “rad” after radians</source>
        <translation>Antihorario. Los números solos son grados; escriba «rad» tras los radianes</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Desde</translation>
    </message>
    <message>
        <source>One end of the finish</source>
        <translation>Un extremo de la meta</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Hasta</translation>
    </message>
    <message>
        <source>The other end of the finish</source>
        <translation>El otro extremo de la meta</translation>
    </message>
    <message>
        <source>Center</source>
        <translation>Centro</translation>
    </message>
    <message>
        <source>Middle of the circle in the coordinates of its body</source>
        <translation>Centro del círculo en las coordenadas de su cuerpo</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>From the middle to the rim</source>
        <translation>Del centro al contorno</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Puntos</translation>
    </message>
    <message>
        <source>How many corners the shape has; move them on the canvas</source>
        <translation>Cuántas esquinas tiene la forma; se mueven en el lienzo</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Grosor</translation>
    </message>
    <message>
        <source>How far behind the line counts as inside the wall; nothing for a wall without a back</source>
        <translation>Hasta qué distancia tras la línea se está dentro del muro; vacío: un muro sin dorso</translation>
    </message>
    <message>
        <source>no back</source>
        <translation>sin dorso</translation>
    </message>
    <message>
        <source>Closed: the last point joins the first</source>
        <translation>Cerrado: el último punto se une al primero</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>Nothing: area times density</source>
        <translation>Vacío: área por densidad</translation>
    </message>
    <message>
        <source>from shape</source>
        <translation>según la forma</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densidad</translation>
    </message>
    <message>
        <source>Counts while no mass is given; a metre of wall weighs 1 kg times the density</source>
        <translation>Cuenta mientras no se dé una masa; un metro de muro pesa 1 kg por la densidad</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Restitución</translation>
    </message>
    <message>
        <source>Share of the speed that is left after a bounce</source>
        <translation>Parte de la velocidad que queda tras un rebote</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Fricción</translation>
    </message>
    <message>
        <source>Coefficient of friction: force along a surface per force on it</source>
        <translation>Coeficiente de fricción: fuerza a lo largo de una superficie por fuerza sobre ella</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Of the center of mass at the start</source>
        <translation>Del centro de masa al principio</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Giro</translation>
    </message>
    <message>
        <source>Turning at the start, anticlockwise</source>
        <translation>Rotación al principio, antihoraria</translation>
    </message>
    <message>
        <source>Linear damping</source>
        <translation>Amortiguación lineal</translation>
    </message>
    <message>
        <source>Share of the velocity that is lost each second</source>
        <translation>Parte de la velocidad que se pierde cada segundo</translation>
    </message>
    <message>
        <source>Angular damping</source>
        <translation>Amortiguación angular</translation>
    </message>
    <message>
        <source>Share of the spin that is lost each second</source>
        <translation>Parte del giro que se pierde cada segundo</translation>
    </message>
    <message>
        <source>Frozen: held in place</source>
        <translation>Congelado: fijo en su sitio</translation>
    </message>
    <message>
        <source>First body</source>
        <translation>Primer cuerpo</translation>
    </message>
    <message>
        <source>Name or key of the body that it holds</source>
        <translation>Nombre o clave del cuerpo que sujeta</translation>
    </message>
    <message>
        <source>Second body</source>
        <translation>Segundo cuerpo</translation>
    </message>
    <message>
        <source>Name or key of the other body that it holds</source>
        <translation>Nombre o clave del otro cuerpo que sujeta</translation>
    </message>
    <message>
        <source>Anchor on first</source>
        <translation>Anclaje en el 1.º</translation>
    </message>
    <message>
        <source>Where it holds the first body, in the coordinates of that</source>
        <translation>Por dónde sujeta el primer cuerpo, en las coordenadas de este</translation>
    </message>
    <message>
        <source>Anchor on second</source>
        <translation>Anclaje en el 2.º</translation>
    </message>
    <message>
        <source>Where it holds the second body, in the coordinates of that</source>
        <translation>Por dónde sujeta el segundo cuerpo, en las coordenadas de este</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>At which it neither pulls nor pushes; nothing: the distance at the start</source>
        <translation>Con la que ni tira ni empuja; vacío: la distancia al principio</translation>
    </message>
    <message>
        <source>as placed</source>
        <translation>según posición</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>Force per metre of stretch</source>
        <translation>Fuerza por metro de estiramiento</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source>Force against the speed of stretching</source>
        <translation>Fuerza contra la velocidad de estiramiento</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Tensión</translation>
    </message>
    <message>
        <source>How the force of the spring is limited</source>
        <translation>Cómo se limita la fuerza del muelle</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Límite</translation>
    </message>
    <message>
        <source>Most tension, where it is limited</source>
        <translation>Tensión máxima, si está limitada</translation>
    </message>
    <message>
        <source>Untouched part</source>
        <translation>Parte intacta</translation>
    </message>
    <message>
        <source>Share of the limit below which “partial tanh” changes nothing</source>
        <translation>Parte del límite por debajo de la cual «tanh parcial» no cambia nada</translation>
    </message>
    <message>
        <source>Slack: pulls only</source>
        <translation>Floja: solo tira</translation>
    </message>
    <message>
        <source>Its two bodies may collide</source>
        <translation>Sus dos cuerpos pueden chocar</translation>
    </message>
    <message>
        <source>Tangible: others bounce off it</source>
        <translation>Tangible: otros rebotan en él</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Es</translation>
    </message>
    <message>
        <source>Tags that say what it is</source>
        <translation>Etiquetas que dicen lo que es</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Toca</translation>
    </message>
    <message>
        <source>Two bodies meet when each touches a tag that the other has</source>
        <translation>Dos cuerpos chocan si cada uno toca una etiqueta que tiene el otro</translation>
    </message>
    <message>
        <source>Of the level, as players see it</source>
        <translation>Del nivel, como lo ven los jugadores</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Who made it</source>
        <translation>Quién lo hizo</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Descripción</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fondo</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Vidas</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Intentos</translation>
    </message>
    <message>
        <source>Tow range</source>
        <translation>Alcance</translation>
    </message>
    <message>
        <source>Greatest distance of ship and payload at which the rope can be attached</source>
        <translation>Distancia máxima entre nave y carga a la que se puede enganchar la cuerda</translation>
    </message>
    <message>
        <source>Towing turns gravity round</source>
        <translation>Remolcar invierte la gravedad</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Acceleration of everything that falls</source>
        <translation>Aceleración de todo lo que cae</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Actualización</translation>
    </message>
    <message>
        <source>Time that one update simulates</source>
        <translation>Tiempo que simula una actualización</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>Passes of motion and collision in one update; more are more exact and slower</source>
        <translation>Pasadas de movimiento y colisión en una actualización; más son más exactas y más lentas</translation>
    </message>
    <message>
        <source>Sub-steps</source>
        <translation>Subpasos</translation>
    </message>
    <message>
        <source>Steps of motion in one iteration</source>
        <translation>Pasos de movimiento en una iteración</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Nave</translation>
    </message>
    <message>
        <source>Tow rope</source>
        <translation>Cuerda de remolque</translation>
    </message>
    <message>
        <source>Bodies at rest sleep</source>
        <translation>Cuerpos en reposo duermen</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Propulsión</translation>
    </message>
    <message>
        <source>Force along the nose of the ship</source>
        <translation>Fuerza en la dirección del morro de la nave</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Dirección</translation>
    </message>
    <message>
        <source>How fast the ship begins to turn while a direction is held</source>
        <translation>Con qué rapidez empieza a girar la nave mientras se mantiene una dirección</translation>
    </message>
    <message>
        <source>Of the ship alone</source>
        <translation>Solo de la nave</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ancho</translation>
    </message>
    <message>
        <source>Of the rectangle, along its own side; the middle stays where it is</source>
        <translation>Del rectángulo, a lo largo de su propio lado; el centro se queda donde está</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Alto</translation>
    </message>
</context>
<context>
    <name>KeyFileTexts</name>
    <message>
        <source>“%1” needs a list of keys, as in [&quot;Ctrl+S&quot;].</source>
        <translation>«%1» necesita una lista de teclas, como en [&quot;Ctrl+S&quot;].</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no key.</source>
        <translation>«%1» de «%2» no es una tecla.</translation>
    </message>
    <message>
        <source>%1 is given to “%2” and to “%3”.</source>
        <translation>%1 está asignado a «%2» y a «%3».</translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2.</source>
        <translation>La línea %1 no es JSON: %2.</translation>
    </message>
    <message>
        <source>These keys were written by a newer version of the program.</source>
        <translation>Estas teclas se guardaron con una versión más nueva del programa.</translation>
    </message>
    <message>
        <source>There are no keys in it; it should look like {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</source>
        <translation>No contiene teclas; debería ser algo así: {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</translation>
    </message>
</context>
<context>
    <name>KeyTexts</name>
    <message>
        <source>That is no single key.</source>
        <translation>Eso no es una sola tecla.</translation>
    </message>
    <message>
        <source>%1 belongs to the drawing board and cannot be given away.</source>
        <translation>%1 pertenece al lienzo y no se puede asignar.</translation>
    </message>
    <message>
        <source>%1 goes from field to field and cannot be given away.</source>
        <translation>%1 pasa de un campo a otro y no se puede asignar.</translation>
    </message>
    <message>
        <source>“%1” works while a game is running too, when plain keys are the game&apos;s: use Ctrl, Alt or a function key with it.</source>
        <translation>«%1» también funciona durante la partida, cuando las teclas solas son del juego: combínela con Ctrl, Alt o una tecla de función.</translation>
    </message>
    <message>
        <source>In the game</source>
        <translation>En el juego</translation>
    </message>
    <message>
        <source>%1 cannot be a key of the game: choose one without Ctrl and Alt that is no function key.</source>
        <translation>%1 no puede ser una tecla del juego: elija una sin Ctrl ni Alt que no sea una tecla de función.</translation>
    </message>
    <message>
        <source>%1 always shows the menu of the game.</source>
        <translation>%1 muestra siempre el menú del juego.</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Click · Shift or Ctrl + click</source>
        <translation>Clic · Mayús o Ctrl + clic</translation>
    </message>
    <message>
        <source>Select · add to the selection or take from it</source>
        <translation>Seleccionar · añadir a la selección o quitar de ella</translation>
    </message>
    <message>
        <source>Drag on empty space</source>
        <translation>Arrastrar en lo vacío</translation>
    </message>
    <message>
        <source>Select with a rubber band; Alt or B: only what lies wholly inside</source>
        <translation>Seleccionar con un marco; Alt o B: solo lo que queda dentro por entero</translation>
    </message>
    <message>
        <source>Alt + click · B + click</source>
        <translation>Alt + clic · B + clic</translation>
    </message>
    <message>
        <source>Select the next object underneath; a right click lists them all</source>
        <translation>Seleccionar el siguiente objeto de debajo; clic derecho: lista de todos</translation>
    </message>
    <message>
        <source>Alt + drag · B + drag</source>
        <translation>Alt + arrastrar · B + arrastrar</translation>
    </message>
    <message>
        <source>Move the selection from anywhere</source>
        <translation>Mover la selección desde cualquier sitio</translation>
    </message>
    <message>
        <source>Enter or right click</source>
        <translation>Intro o clic derecho</translation>
    </message>
    <message>
        <source>End the shape that is being drawn</source>
        <translation>Terminar la forma que se está dibujando</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Take back the last point</source>
        <translation>Quitar el último punto</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel: gesture, shape, selection, tool</source>
        <translation>Cancelar: gesto, forma, selección, herramienta</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>Move the selection a little; Shift: a grid step; Alt: a pixel</source>
        <translation>Mover un poco la selección; Mayús: un paso de cuadrícula; Alt: un píxel</translation>
    </message>
    <message>
        <source>Wheel · pinch</source>
        <translation>Rueda · pellizco</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Zoom en el puntero</translation>
    </message>
    <message>
        <source>Middle or right drag · Space + drag · two fingers</source>
        <translation>Arrastrar con botón central o derecho · Espacio + arrastrar · dos dedos</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Mover la vista</translation>
    </message>
    <message>
        <source>On the drawing board</source>
        <translation>En el lienzo</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Propulsión</translation>
    </message>
    <message>
        <source>Tow the payload when it is near; again: let it go</source>
        <translation>Remolcar la carga cuando está cerca; otra vez: soltarla</translation>
    </message>
    <message>
        <source>Hold the game and show the menu</source>
        <translation>Pausar el juego y mostrar el menú</translation>
    </message>
    <message>
        <source>Let the view follow the ship again</source>
        <translation>Hacer que la vista siga otra vez a la nave</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Girar a la izquierda</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Girar a la derecha</translation>
    </message>
    <message>
        <source>Hold the game, or go on</source>
        <translation>Pausar el juego, o seguir</translation>
    </message>
    <message>
        <source>Hold the game and advance it by one update</source>
        <translation>Pausar el juego y avanzarlo un paso</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Empezar el nivel de nuevo</translation>
    </message>
    <message>
        <source>Let time run slower</source>
        <translation>Hacer que el tiempo vaya más lento</translation>
    </message>
    <message>
        <source>Let time run faster</source>
        <translation>Hacer que el tiempo vaya más rápido</translation>
    </message>
    <message>
        <source>While held: one update back</source>
        <translation>En pausa: una actualización atrás</translation>
    </message>
    <message>
        <source>While held: one update on</source>
        <translation>En pausa: una actualización adelante</translation>
    </message>
    <message>
        <source>Turn time back, as long as the key is held</source>
        <translation>Retroceder en el tiempo mientras se mantiene la tecla</translation>
    </message>
    <message>
        <source>Shift · Ctrl while moving or drawing</source>
        <translation>Mayús · Ctrl al mover o dibujar</translation>
    </message>
    <message>
        <source>Keep to an axis or to steps of 15° · switch snapping off or on for the moment</source>
        <translation>Mantenerse en un eje o en pasos de 15° · desactivar o activar el ajuste por un momento</translation>
    </message>
    <message>
        <source>Shift · Ctrl while drawing a rectangle</source>
        <translation>Mayús · Ctrl al dibujar un rectángulo</translation>
    </message>
    <message>
        <source>From its middle · a square</source>
        <translation>Desde su centro · un cuadrado</translation>
    </message>
    <message>
        <source>Shift · Ctrl · Alt while scaling</source>
        <translation>Mayús · Ctrl · Alt al escalar</translation>
    </message>
    <message>
        <source>About the middle · keep the proportions · switch snapping off or on</source>
        <translation>Desde el centro · mantener las proporciones · desactivar o activar el ajuste</translation>
    </message>
    <message>
        <source>Shift · Ctrl while turning</source>
        <translation>Mayús · Ctrl al girar</translation>
    </message>
    <message>
        <source>About the opposite corner · in steps of 15°</source>
        <translation>Alrededor de la esquina opuesta · en pasos de 15°</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Bounding box</source>
        <translation>Caja delimitadora</translation>
    </message>
    <message>
        <source>Box of the broad phase, with room to move</source>
        <translation>Caja de la fase amplia, con margen de movimiento</translation>
    </message>
    <message>
        <source>Largest circle about the centroid</source>
        <translation>Mayor círculo en torno al centroide</translation>
    </message>
    <message>
        <source>Way of the next second</source>
        <translation>Camino del próximo segundo</translation>
    </message>
    <message>
        <source>Up, 1 m</source>
        <translation>Arriba, 1 m</translation>
    </message>
    <message>
        <source>Free side, 1 m</source>
        <translation>Lado libre, 1 m</translation>
    </message>
    <message>
        <source>Solid band behind the wall</source>
        <translation>Franja sólida detrás del muro</translation>
    </message>
    <message>
        <source>Cell of what stands still</source>
        <translation>Celda de lo que está quieto</translation>
    </message>
    <message>
        <source>Cell of what moves</source>
        <translation>Celda de lo que se mueve</translation>
    </message>
    <message>
        <source>Point of contact</source>
        <translation>Punto de contacto</translation>
    </message>
    <message>
        <source>Near, not touching yet</source>
        <translation>Cerca, aún sin tocarse</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>Pressed to half its length</source>
        <translation>Comprimido a la mitad de su longitud</translation>
    </message>
    <message>
        <source>At its natural length</source>
        <translation>Longitud natural</translation>
    </message>
    <message>
        <source>Stretched by half its length</source>
        <translation>Estirado a una vez y media</translation>
    </message>
    <message>
        <source>Way, older ones fainter</source>
        <translation>Camino, más tenue cuanto más antiguo</translation>
    </message>
    <message>
        <source>Center of mass and axes</source>
        <translation>Centro de masa y ejes</translation>
    </message>
    <message>
        <source>Name of the object</source>
        <translation>Nombre del objeto</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Dormido</translation>
    </message>
    <message>
        <source>Deep enough for what comes</source>
        <translation>Lo bastante profundo para lo que llega</translation>
    </message>
    <message>
        <source>Passed through in one iteration</source>
        <translation>Se atraviesa en una iteración</translation>
    </message>
    <message>
        <source>The selection collides with it</source>
        <translation>La selección choca con ello</translation>
    </message>
    <message>
        <source>The selection passes through</source>
        <translation>La selección lo atraviesa</translation>
    </message>
    <message>
        <source>One color an island</source>
        <translation>Un color por isla</translation>
    </message>
    <message>
        <source>The color of the first tag; a dot for each further one</source>
        <translation>El color de la primera etiqueta; un punto por cada una de las demás</translation>
    </message>
    <message>
        <source>Force; 1 m is the weight of the lighter one, 2 m ten times as much</source>
        <translation>Fuerza; 1 m es el peso del más ligero, 2 m diez veces más</translation>
    </message>
    <message>
        <source>Way in the time that is kept</source>
        <translation>Trayecto en el tiempo conservado</translation>
    </message>
    <message>
        <source>Way in a future given up, dashed</source>
        <translation>Trayecto en un futuro abandonado, a trazos</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>One-way wall</source>
        <translation>Muro de una cara</translation>
    </message>
    <message>
        <source>Two-way line</source>
        <translation>Línea de dos caras</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polígono</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Círculo</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Cuerpo</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Nave</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Carga</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Meta</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Conector</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Capa</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 at %2; %3</source>
        <translation>%1 en %2; %3</translation>
    </message>
</context>
<context>
    <name>ObjectFilter</name>
    <message>
        <source>wall</source>
        <translation>muro</translation>
    </message>
    <message>
        <source>line</source>
        <translation>línea</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polígono</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>círculo</translation>
    </message>
    <message>
        <source>static</source>
        <translation>estático</translation>
    </message>
    <message>
        <source>kinematic</source>
        <translation>cinemático</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dinámico</translation>
    </message>
    <message>
        <source>ship</source>
        <translation>nave</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>meta</translation>
    </message>
    <message>
        <source>connector</source>
        <translation>conector</translation>
    </message>
    <message>
        <source>group</source>
        <translation>grupo</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>capa</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>&amp;Inspector</source>
        <translation>&amp;Inspector</translation>
    </message>
    <message>
        <source>&amp;Outliner</source>
        <translation>&amp;Esquema</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Problemas</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nodos</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historial</translation>
    </message>
    <message>
        <source>&amp;Minimap</source>
        <translation>&amp;Minimapa</translation>
    </message>
    <message>
        <source>&amp;Level Properties</source>
        <translation>P&amp;ropiedades del nivel</translation>
    </message>
    <message>
        <source>&amp;Tag Matrix</source>
        <translation>Ma&amp;triz de etiquetas</translation>
    </message>
    <message>
        <source>&amp;Differences</source>
        <translation>&amp;Diferencias</translation>
    </message>
    <message>
        <source>Show or hide this panel</source>
        <translation>Mostrar u ocultar este panel</translation>
    </message>
    <message>
        <source>&amp;Flights</source>
        <translation>&amp;Vuelos</translation>
    </message>
    <message>
        <source>&amp;Run Changes</source>
        <translation>C&amp;ambios en ejecución</translation>
    </message>
    <message>
        <source>E&amp;xplain</source>
        <translation>E&amp;xplicación</translation>
    </message>
    <message>
        <source>Plot&amp;s</source>
        <translation>&amp;Gráficas</translation>
    </message>
    <message>
        <source>Profil&amp;e</source>
        <translation>Per&amp;fil</translation>
    </message>
</context>
<context>
    <name>Plots</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>velocity to the right</source>
        <translation>velocidad hacia la derecha</translation>
    </message>
    <message>
        <source>velocity upwards</source>
        <translation>velocidad hacia arriba</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>rapidez</translation>
    </message>
    <message>
        <source>angular velocity</source>
        <translation>velocidad angular</translation>
    </message>
    <message>
        <source>force to the right</source>
        <translation>fuerza hacia la derecha</translation>
    </message>
    <message>
        <source>force upwards</source>
        <translation>fuerza hacia arriba</translation>
    </message>
    <message>
        <source>force of contacts</source>
        <translation>fuerza de los contactos</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>energía cinética</translation>
    </message>
    <message>
        <source>potential energy</source>
        <translation>energía potencial</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energía</translation>
    </message>
    <message>
        <source>momentum to the right</source>
        <translation>momento lineal hacia la derecha</translation>
    </message>
    <message>
        <source>momentum upwards</source>
        <translation>momento lineal hacia arriba</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>momento angular</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longitud</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>tensión</translation>
    </message>
    <message>
        <source>elastic energy</source>
        <translation>energía elástica</translation>
    </message>
    <message>
        <source>energy of everything</source>
        <translation>energía del conjunto</translation>
    </message>
    <message>
        <source>kinetic energy of everything</source>
        <translation>energía cinética del conjunto</translation>
    </message>
    <message>
        <source>potential energy of everything</source>
        <translation>energía potencial del conjunto</translation>
    </message>
    <message>
        <source>elastic energy of everything</source>
        <translation>energía elástica del conjunto</translation>
    </message>
    <message>
        <source>drift of energy</source>
        <translation>deriva de la energía</translation>
    </message>
    <message>
        <source>momentum of everything to the right</source>
        <translation>momento lineal del conjunto hacia la derecha</translation>
    </message>
    <message>
        <source>momentum of everything upwards</source>
        <translation>momento lineal del conjunto hacia arriba</translation>
    </message>
    <message>
        <source>drift of momentum</source>
        <translation>deriva del momento lineal</translation>
    </message>
    <message>
        <source>angular momentum of everything</source>
        <translation>momento angular de todo</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Movimiento</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Pares</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contactos</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solucionador</translation>
    </message>
    <message>
        <source>Time of impact</source>
        <translation>Instante de impacto</translation>
    </message>
    <message>
        <source>Crushing</source>
        <translation>Aplastamiento</translation>
    </message>
    <message>
        <source>Advance</source>
        <translation>Avance</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Toques</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>Sueño</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>ProfilePanel</name>
    <message>
        <source>Static bodies</source>
        <translation>Cuerpos estáticos</translation>
    </message>
    <message>
        <source>Kinematic bodies</source>
        <translation>Cuerpos cinemáticos</translation>
    </message>
    <message>
        <source>Dynamic bodies</source>
        <translation>Cuerpos dinámicos</translation>
    </message>
    <message>
        <source>Awake</source>
        <translation>Despiertos</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Dormido</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Conectores</translation>
    </message>
    <message>
        <source>Pairs that may meet</source>
        <translation>Pares que pueden encontrarse</translation>
    </message>
    <message>
        <source>Pairs that touch</source>
        <translation>Pares que se tocan</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Islas</translation>
    </message>
    <message>
        <source>Leaves of the quadtrees</source>
        <translation>Hojas de los quadtrees</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Re Pág</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Av Pág</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
</context>
<context>
    <name>Reach</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>TagNames</name>
    <message>
        <source>There is a tag of this name already.</source>
        <translation>Ya hay una etiqueta con este nombre.</translation>
    </message>
    <message>
        <source>That is how a tag without a name is written.</source>
        <translation>Así se escribe una etiqueta sin nombre.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.</source>
        <translation>Dibujar niveles y volar en ellos: un editor de niveles y zona de pruebas de física.</translation>
    </message>
    <message>
        <source>Level files to open; without any, what was open last.</source>
        <translation>Archivos de nivel que abrir; sin ninguno, lo último que estuvo abierto.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The file declares entities of its own (line %1), which are not read because they can be made to grow without end. Save it as plain SVG, for example with Inkscape, and try again.</source>
        <translation>El archivo declara entidades propias (línea %1), que no se leen porque pueden crecer sin fin. Guárdelo como SVG plano, por ejemplo con Inkscape, e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The import was stopped; nothing was changed.</source>
        <translation>La importación se detuvo; no se cambió nada.</translation>
    </message>
    <message>
        <source>The file is compressed. Unpack it first, or save it as plain SVG instead of SVGZ.</source>
        <translation>El archivo está comprimido. Descomprímalo primero, o guárdelo como SVG plano en vez de SVGZ.</translation>
    </message>
    <message>
        <source>This is no file that can be imported: SVG drawings, maps of Tiled (.tmx, .tmj) and scenes of R.U.B.E. (.json) can.</source>
        <translation>Este archivo no se puede importar. Se pueden importar dibujos SVG, mapas de Tiled (.tmx, .tmj) y escenas de R.U.B.E. (.json).</translation>
    </message>
    <message>
        <source>This is a level already: open it instead of importing it.</source>
        <translation>Esto ya es un nivel: ábralo en vez de importarlo.</translation>
    </message>
    <message>
        <source>This is a tileset or a template of Tiled, which draws nothing. Import a map.</source>
        <translation>Esto es un conjunto de teselas o una plantilla de Tiled, que no dibuja nada. Importe un mapa.</translation>
    </message>
    <message>
        <source>At this scale something would lie more than %1 m away. Choose a smaller scale.</source>
        <translation>Con esta escala algo quedaría a más de %1 m. Elija una escala menor.</translation>
    </message>
    <message>
        <source>The result would have more than %1 vertices. Choose a larger tolerance.</source>
        <translation>El resultado tendría más de %1 vértices. Elija una tolerancia mayor.</translation>
    </message>
    <message>
        <source>There is nothing in this file that could become part of a level.</source>
        <translation>En este archivo no hay nada que pueda formar parte de un nivel.</translation>
    </message>
    <message>
        <source>Text was left out (%4). Turn it into paths to have it.</source>
        <translation>Se omitió texto (%4). Conviértalo en trayectos para tenerlo.</translation>
    </message>
    <message>
        <source>Pictures were left out (%4).</source>
        <translation>Se omitieron imágenes (%4).</translation>
    </message>
    <message>
        <source>Content in another language than SVG was left out (%4).</source>
        <translation>Se omitió contenido en otro lenguaje que no es SVG (%4).</translation>
    </message>
    <message>
        <source>Animations were left out (%4).</source>
        <translation>Se omitieron animaciones (%4).</translation>
    </message>
    <message>
        <source>Scripts were left out (%4).</source>
        <translation>Se omitieron scripts (%4).</translation>
    </message>
    <message>
        <source>Some selectors of a style sheet are not understood (%4): what they say of fill and stroke was not taken over.</source>
        <translation>Algunos selectores de una hoja de estilos no se entienden (%4): no se tomó lo que dicen de relleno y trazo.</translation>
    </message>
    <message>
        <source>What is not displayed was left out (%4).</source>
        <translation>Se omitió lo que no se muestra (%4).</translation>
    </message>
    <message>
        <source>Shapes without fill and stroke were left out (%4).</source>
        <translation>Se omitieron formas sin relleno ni trazo (%4).</translation>
    </message>
    <message>
        <source>A transform is not understood and was left out (%4).</source>
        <translation>Una transformación no se entiende y se omitió (%4).</translation>
    </message>
    <message>
        <source>Clips and masks were not applied: shapes are there as a whole (%4).</source>
        <translation>No se aplicaron recortes ni máscaras: las formas están enteras (%4).</translation>
    </message>
    <message>
        <source>Filters were not applied (%4).</source>
        <translation>No se aplicaron filtros (%4).</translation>
    </message>
    <message>
        <source>References to what is not in the file, or to themselves, were left out (%4): %3</source>
        <translation>Se omitieron referencias a lo que no está en el archivo, o a sí mismas (%4): %3</translation>
    </message>
    <message>
        <source>The data of shapes has a mistake; they are there up to it (%4).</source>
        <translation>Los datos de algunas formas tienen un error; llegan hasta él (%4).</translation>
    </message>
    <message>
        <source>Shapes without any extent were left out (%4).</source>
        <translation>Se omitieron formas sin extensión (%4).</translation>
    </message>
    <message>
        <source>Areas with holes, or in several parts, were cut into several polygons (%4).</source>
        <translation>Las áreas con agujeros, o en varias partes, se cortaron en varios polígonos (%4).</translation>
    </message>
    <message>
        <source>Polygons of more than 1024 vertices became walls (%4). A larger tolerance makes fewer vertices.</source>
        <translation>Los polígonos de más de 1024 vértices pasaron a ser muros (%4). Una tolerancia mayor da menos vértices.</translation>
    </message>
    <message>
        <source>Areas that cross themselves very often became walls (%4).</source>
        <translation>Las áreas que se cruzan a sí mismas muchas veces pasaron a ser muros (%4).</translation>
    </message>
    <message>
        <source>Layers of tiles were left out, for a level has no tiles: %3 (%4). Objects of object layers are taken over.</source>
        <translation>Se omitieron capas de teselas, pues un nivel no tiene teselas: %3 (%4). Los objetos de las capas de objetos se toman.</translation>
    </message>
    <message>
        <source>Layers of pictures were left out: %3 (%4).</source>
        <translation>Se omitieron capas de imágenes: %3 (%4).</translation>
    </message>
    <message>
        <source>Tilesets are not needed and were not read: %3.</source>
        <translation>Los conjuntos de teselas no hacen falta y no se leyeron: %3.</translation>
    </message>
    <message>
        <source>Objects that are tiles were left out (%4).</source>
        <translation>Se omitieron objetos que son teselas (%4).</translation>
    </message>
    <message>
        <source>Objects made of templates were left out, for these are in other files (%4). Detach them in Tiled.</source>
        <translation>Se omitieron objetos hechos con plantillas, pues estas están en otros archivos (%4). Sepárelos en Tiled.</translation>
    </message>
    <message>
        <source>Objects of a form that is not known here were left out (%4).</source>
        <translation>Se omitieron objetos de una forma que aquí no se conoce (%4).</translation>
    </message>
    <message>
        <source>Points were left out (%4): only those of the class “ship” or “payload” become something.</source>
        <translation>Se omitieron puntos (%4): solo los de la clase «ship» o «payload» pasan a ser algo.</translation>
    </message>
    <message>
        <source>Properties that mean nothing here were left out (%4): %3.</source>
        <translation>Se omitieron propiedades que aquí no significan nada (%4): %3.</translation>
    </message>
    <message>
        <source>The opacity of layers was not taken over: %3 (%4).</source>
        <translation>No se tomó la opacidad de las capas: %3 (%4).</translation>
    </message>
    <message>
        <source>The parallax of layers was not taken over: %3 (%4).</source>
        <translation>No se tomó el paralaje de las capas: %3 (%4).</translation>
    </message>
    <message>
        <source>Gravity was not taken over (%4): the level keeps its own.</source>
        <translation>No se tomó la gravedad (%4): el nivel conserva la suya.</translation>
    </message>
    <message>
        <source>Numbers that a level cannot have were brought into its range (%4): %3.</source>
        <translation>Los números que un nivel no puede tener se llevaron a su rango (%4): %3.</translation>
    </message>
    <message>
        <source>Fixtures without a sound shape were left out (%4).</source>
        <translation>Se omitieron fijaciones sin una forma correcta (%4).</translation>
    </message>
    <message>
        <source>Group indices of filters were not taken over (%4): %3</source>
        <translation>No se tomaron los índices de grupo de los filtros (%4): %3</translation>
    </message>
    <message>
        <source>Fixtures of one body differ in material or filter: those of the first were taken (%4): %3</source>
        <translation>Las fijaciones de un cuerpo difieren en material o filtro: se tomaron los de la primera (%4): %3</translation>
    </message>
    <message>
        <source>Sensors of bodies that also have solid fixtures were left out (%4): %3</source>
        <translation>Se omitieron sensores de cuerpos que también tienen fijaciones sólidas (%4): %3</translation>
    </message>
    <message>
        <source>Settings of bodies that mean nothing here were left out (%4): %3</source>
        <translation>Se omitieron ajustes de cuerpos que aquí no significan nada (%4): %3</translation>
    </message>
    <message>
        <source>Bodies without fixtures were left out (%4): %3</source>
        <translation>Se omitieron cuerpos sin fijaciones (%4): %3</translation>
    </message>
    <message>
        <source>Joints that no connector can be were left out (%4): %3</source>
        <translation>Se omitieron articulaciones que ningún conector puede ser (%4): %3</translation>
    </message>
    <message>
        <source>Rigid joints became stiff connectors (%4): %3</source>
        <translation>Las articulaciones rígidas pasaron a ser conectores rígidos (%4): %3</translation>
    </message>
    <message>
        <source>The level has a ship, a payload or a finish already; those of the file were left out.</source>
        <translation>El nivel ya tiene nave, carga o meta; se omitieron las del archivo.</translation>
    </message>
    <message>
        <source>All 32 tags are taken; these were left out: %3</source>
        <translation>Las 32 etiquetas están ocupadas; se omitieron estas: %3</translation>
    </message>
    <message>
        <source>One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what comes from the left of the drawing direction is stopped</source>
        <translation>Muro de una cara · clic: primer punto · arrastrar: primer segmento · Ctrl: ajuste no/sí · se detiene lo que viene de la izquierda del sentido de dibujo</translation>
    </message>
    <message>
        <source>Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Puntos: %1 · clic: añadir · clic en el primer punto: cerrar · Intro o clic derecho: terminar · Retroceso: deshacer punto · cifras: escribir longitud y ángulo · Mayús: 15° · Ctrl: ajuste no/sí · longitud %2 m, ángulo %3°</translation>
    </message>
    <message>
        <source>Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel</source>
        <translation>Puntos: %1 · clic: cerrar la cadena · Intro o clic derecho: terminarla abierta · Esc: cancelar</translation>
    </message>
    <message>
        <source>A chain of walls needs two points: click to add another, or Escape to cancel</source>
        <translation>Una cadena de muros necesita dos puntos: haga clic para añadir otro, o pulse Esc para cancelar</translation>
    </message>
    <message>
        <source>This is where the last point is already: move on before you click</source>
        <translation>Aquí está ya el último punto: avance antes de hacer clic</translation>
    </message>
    <message>
        <source>Click or drag: go on with this chain, which keeps its direction · Alt or B + click: begin a chain of its own here</source>
        <translation>Clic o arrastrar: continuar esta cadena, que conserva su dirección · Alt o B + clic: empezar aquí una cadena propia</translation>
    </message>
    <message>
        <source>Click: close the chain at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Clic: cerrar la cadena en su otro extremo · Intro o clic derecho: terminarla abierta · Esc: dejarla como estaba</translation>
    </message>
    <message>
        <source>Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on</source>
        <translation>Línea de dos caras · clic: primer punto · arrastrar: primer segmento · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>Click or drag: go on with this line · Alt or B + click: begin a line of its own here</source>
        <translation>Clic o arrastrar: continuar esta línea · Alt o B + clic: empezar aquí una línea propia</translation>
    </message>
    <message>
        <source>Click: close the line at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Clic: cerrar la línea en su otro extremo · Intro o clic derecho: terminarla abierta · Esc: dejarla como estaba</translation>
    </message>
    <message>
        <source>Polygon · click: first corner · drag: first side · Ctrl: snap off/on</source>
        <translation>Polígono · clic: primera esquina · arrastrar: primer lado · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>Corners: %1 · click: add · click the first corner, Enter or right click: close · Backspace: undo corner · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Esquinas: %1 · clic: añadir · clic en la primera esquina, Intro o clic derecho: cerrar · Retroceso: deshacer esquina · cifras: escribir longitud y ángulo · Mayús: 15° · Ctrl: ajuste no/sí · longitud %2 m, ángulo %3°</translation>
    </message>
    <message>
        <source>Corners: %1 · click: close the polygon · Escape: cancel</source>
        <translation>Esquinas: %1 · clic: cerrar el polígono · Esc: cancelar</translation>
    </message>
    <message>
        <source>A polygon needs three corners: click to add another, or Escape to cancel</source>
        <translation>Un polígono necesita tres esquinas: haga clic para añadir otra, o pulse Esc para cancelar</translation>
    </message>
    <message>
        <source>This is where the last corner is already: move on before you click</source>
        <translation>Aquí está ya la última esquina: avance antes de hacer clic</translation>
    </message>
    <message>
        <source>This side would run through another one, and a polygon must not cross itself · move on before you click</source>
        <translation>Este lado atravesaría otro, y un polígono no debe cruzarse a sí mismo · avance antes de hacer clic</translation>
    </message>
    <message>
        <source>The polygon crosses itself where it is marked and cannot be finished like this · Backspace: undo corner</source>
        <translation>El polígono se cruza a sí mismo donde está marcado y no se puede terminar así · Retroceso: deshacer esquina</translation>
    </message>
    <message>
        <source>Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on</source>
        <translation>Al cerrarlo aquí, el polígono se cruzaría a sí mismo · Retroceso: deshacer esquina · clic: continuar</translation>
    </message>
    <message>
        <source>All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner</source>
        <translation>Todas las esquinas están en una línea: un polígono necesita un interior · clic: añadir una esquina · Retroceso: deshacer esquina</translation>
    </message>
    <message>
        <source>Rectangle · drag from corner to corner, or click both, or click one and type the size · Shift: from the middle · Ctrl: square</source>
        <translation>Rectángulo · arrastre de esquina a esquina, haga clic en ambas, o haga clic en una y escriba el tamaño · Mayús: desde el centro · Ctrl: cuadrado</translation>
    </message>
    <message>
        <source>Width %1 m, height %2 m · click or release: done · Shift: from the middle · Ctrl: square · Alt or B: snap off/on · Escape: cancel</source>
        <translation>Anchura %1 m, altura %2 m · clic o soltar: listo · Mayús: desde el centro · Ctrl: cuadrado · Alt o B: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>A rectangle needs width and height: move on before you click or release</source>
        <translation>Un rectángulo necesita anchura y altura: avance antes de hacer clic o soltar</translation>
    </message>
    <message>
        <source>Moving body · drag: rectangle · click: first corner of a polygon · then its velocity · Shift: from the middle · Ctrl: square</source>
        <translation>Cuerpo móvil · arrastrar: rectángulo · clic: primera esquina de un polígono · después, su velocidad · Mayús: desde el centro · Ctrl: cuadrado</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · click or drag: set it · digits: type it · Shift: 15° · Ctrl: snap off/on · Enter, right click or Escape: leave the body at rest</source>
        <translation>Velocidad %1 m/s, %2° · clic o arrastrar: fijarla · cifras: escribirla · Mayús: 15° · Ctrl: ajuste no/sí · Intro, clic derecho o Esc: dejar el cuerpo en reposo</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · Shift: 15° · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Velocidad %1 m/s, %2° · Mayús: 15° · Ctrl: ajuste no/sí · soltar: listo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Drag: change the velocity of this body, a metre for each m/s</source>
        <translation>Arrastrar: cambiar la velocidad de este cuerpo, un metro por cada m/s</translation>
    </message>
    <message>
        <source>Connector · drag from one body to another, or click both · anchors snap to nodes, middles and the grid</source>
        <translation>Conector · arrastre de un cuerpo a otro, o haga clic en ambos · los anclajes se ajustan a nodos, puntos medios y cuadrícula</translation>
    </message>
    <message>
        <source>Drag or click: connect “%1” with another body</source>
        <translation>Arrastrar o clic: conectar «%1» con otro cuerpo</translation>
    </message>
    <message>
        <source>Drag or click: connect this fixed body with another one</source>
        <translation>Arrastrar o clic: conectar este cuerpo fijo con otro</translation>
    </message>
    <message>
        <source>Drag or click: connect this moving body with another one</source>
        <translation>Arrastrar o clic: conectar este cuerpo móvil con otro</translation>
    </message>
    <message>
        <source>Drag or click: connect this loose body with another one</source>
        <translation>Arrastrar o clic: conectar este cuerpo suelto con otro</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with “%2” · Escape: cancel</source>
        <translation>Longitud %1 m · soltar o clic: conectar con «%2» · Esc: cancelar</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this fixed body · Escape: cancel</source>
        <translation>Longitud %1 m · soltar o clic: conectar con este cuerpo fijo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this moving body · Escape: cancel</source>
        <translation>Longitud %1 m · soltar o clic: conectar con este cuerpo móvil · Esc: cancelar</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this loose body · Escape: cancel</source>
        <translation>Longitud %1 m · soltar o clic: conectar con este cuerpo suelto · Esc: cancelar</translation>
    </message>
    <message>
        <source>Neither of these two bodies can be moved by a connector, one should be dynamic · release or click: connect them all the same · length %1 m</source>
        <translation>Un conector no puede mover ninguno de estos dos cuerpos; uno debería ser dinámico · soltar o clic: conectarlos de todos modos · longitud %1 m</translation>
    </message>
    <message>
        <source>This is the body where the connector begins: it needs another one</source>
        <translation>En este cuerpo empieza el conector: necesita otro</translation>
    </message>
    <message>
        <source>Connectors join bodies; ship, payload and finish are none</source>
        <translation>Los conectores unen cuerpos; nave, carga y meta no lo son</translation>
    </message>
    <message>
        <source>There is no body here: a connector leads from one body to another</source>
        <translation>Aquí no hay ningún cuerpo: un conector va de un cuerpo a otro</translation>
    </message>
    <message>
        <source>There was no body where the drag began: press on one, then drag to another</source>
        <translation>Donde empezó el arrastre no había ningún cuerpo: pulse sobre uno y arrastre hasta otro</translation>
    </message>
    <message>
        <source>Nothing was connected: release the button over another body</source>
        <translation>No se conectó nada: suelte el botón sobre otro cuerpo</translation>
    </message>
    <message>
        <source>Length and angle · Tab: the other one · an empty one is left to the pointer · Enter or click: place the point · Escape: back to the pointer</source>
        <translation>Longitud y ángulo · Tab: el otro · uno vacío queda para el puntero · Intro o clic: colocar el punto · Esc: volver al puntero</translation>
    </message>
    <message>
        <source>Speed and direction · Tab: the other one · an empty one is left to the pointer · Enter or click: set the velocity · Escape: back to the pointer</source>
        <translation>Velocidad y dirección · Tab: el otro · uno vacío queda para el puntero · Intro o clic: fijar la velocidad · Esc: volver al puntero</translation>
    </message>
    <message>
        <source>Width and height · Tab: the other one · an empty one is left to the pointer · Enter or click: draw the rectangle · Escape: back to the pointer</source>
        <translation>Anchura y altura · Tab: el otro · uno vacío queda para el puntero · Intro o clic: dibujar el rectángulo · Esc: volver al puntero</translation>
    </message>
    <message>
        <source>Radius · Enter or click: draw the circle · Escape: back to the pointer</source>
        <translation>Radio · Intro o clic: dibujar el círculo · Esc: volver al puntero</translation>
    </message>
    <message>
        <source>“%1” is no number in metres: type one such as 2.5, 80 cm or 3/4</source>
        <translation>«%1» no es un número en metros: escriba uno como 2.5, 80 cm o 3/4</translation>
    </message>
    <message>
        <source>“%1” is no angle: type degrees such as 45, −22.5 or 180/7, anticlockwise from the right</source>
        <translation>«%1» no es un ángulo: escriba grados como 45, −22.5 o 180/7, en sentido antihorario desde la derecha</translation>
    </message>
    <message>
        <source>“%1” is too small: a size must be more than nothing</source>
        <translation>«%1» es demasiado pequeño: un tamaño debe ser mayor que cero</translation>
    </message>
    <message>
        <source>Circle · drag from the center, or click it and then click or type the radius · Ctrl: snap off/on</source>
        <translation>Círculo · arrastre desde el centro, o haga clic en él y después haga clic o escriba el radio · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Radio %1 m · clic o soltar: listo · Ctrl: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>A circle needs a radius: move away from the center before you click</source>
        <translation>Un círculo necesita un radio: aléjese del centro antes de hacer clic</translation>
    </message>
    <message>
        <source>Guide · drag: move it · drag onto a ruler: delete it · double click: type place, angle and name</source>
        <translation>Guía · arrastrar: moverla · arrastrar a una regla: eliminarla · doble clic: escribir posición, ángulo y nombre</translation>
    </message>
    <message>
        <source>New guide at %1 m, %2 m · release: done · Ctrl: snap off/on · back onto the ruler or Escape: none</source>
        <translation>Guía nueva en %1 m, %2 m · soltar: listo · Ctrl: ajuste no/sí · volver a la regla o Esc: ninguna</translation>
    </message>
    <message>
        <source>New guide · drag it into the drawing board · Escape: none</source>
        <translation>Guía nueva · arrástrela al lienzo · Esc: ninguna</translation>
    </message>
    <message>
        <source>Guide at %1 m, %2 m, %3° · release: done · Shift: turn · Ctrl: snap off/on · onto a ruler: delete · Escape: cancel</source>
        <translation>Guía en %1 m, %2 m, %3° · soltar: listo · Mayús: girar · Ctrl: ajuste no/sí · a una regla: eliminar · Esc: cancelar</translation>
    </message>
    <message>
        <source>Guide on the ruler · release: delete it · Escape: cancel</source>
        <translation>Guía sobre la regla · soltar: eliminarla · Esc: cancelar</translation>
    </message>
    <message>
        <source>Measure · drag from one point to the other, or click both · Ctrl: snap off/on</source>
        <translation>Medir · arrastre de un punto al otro, o haga clic en ambos · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click or release: done · Shift: 15° · Ctrl: snap off/on · Escape: clear</source>
        <translation>%1 m, a lo ancho %2 m, a lo alto %3 m, %4° · clic o soltar: listo · Mayús: 15° · Ctrl: ajuste no/sí · Esc: borrar</translation>
    </message>
    <message>
        <source>First point · click the other one · Escape: clear</source>
        <translation>Primer punto · haga clic en el otro · Esc: borrar</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, a lo ancho %2 m, a lo alto %3 m, %4° · Ctrl+C: copiar · arrastrar: medir de nuevo · Esc: borrar</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click: angle %5° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, a lo ancho %2 m, a lo alto %3 m, %4° · clic: ángulo %5° · Ctrl+C: copiar · arrastrar: medir de nuevo · Esc: borrar</translation>
    </message>
    <message>
        <source>Angle %1° between %2 m and %3 m · Ctrl+C: copy · click or drag: measure anew · Escape: clear</source>
        <translation>Ángulo %1° entre %2 m y %3 m · Ctrl+C: copiar · clic o arrastrar: medir de nuevo · Esc: borrar</translation>
    </message>
    <message>
        <source>Nodes · click a wall, line, polygon or finish to edit its nodes</source>
        <translation>Nodos · haga clic en un muro, línea, polígono o meta para editar sus nodos</translation>
    </message>
    <message>
        <source>What is selected has no nodes · click a wall, line, polygon or finish to edit it</source>
        <translation>Lo seleccionado no tiene nodos · haga clic en un muro, línea, polígono o meta para editarlo</translation>
    </message>
    <message>
        <source>Nodes · click or rubber band: select nodes · Shift + Alt + drag: lasso · double click on a segment: insert a node · Escape: done</source>
        <translation>Nodos · clic o marco: seleccionar nodos · Mayús + Alt + arrastrar: lazo · doble clic en un segmento: insertar un nodo · Esc: listo</translation>
    </message>
    <message>
        <source>Click: edit the nodes of this object · Shift + click: add it to those in edit</source>
        <translation>Clic: editar los nodos de este objeto · Mayús + clic: añadirlo a los que se editan</translation>
    </message>
    <message>
        <source>%1 nodes selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Shift+J: join · Shift+R: turn the part between them round as a chain of its own · Escape: select none</source>
        <translation>Nodos seleccionados: %1 · arrastrar: mover · flechas: mover un poco · Supr: eliminar · Mayús+B: separar · Mayús+J: unir · Mayús+R: invertir la parte entre ellos como cadena propia · Esc: deseleccionar</translation>
    </message>
    <message>
        <source>Node · drag: move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band · Alt while dragging: leave other nodes at this place behind</source>
        <translation>Nodo · arrastrar: mover · Mayús o Ctrl + clic: añadir o quitar · Mayús + arrastrar: marco · Alt al arrastrar: dejar atrás otros nodos en este lugar</translation>
    </message>
    <message>
        <source>Segment · drag: move both ends · click: select them · double click or Ctrl + Alt + click: insert a node here</source>
        <translation>Segmento · arrastrar: mover ambos extremos · clic: seleccionarlos · doble clic o Ctrl + Alt + clic: insertar aquí un nodo</translation>
    </message>
    <message>
        <source>Click: insert a node here</source>
        <translation>Clic: insertar aquí un nodo</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Mover %1 m, %2 m · Mayús: por un eje · Ctrl: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m together with other nodes at this place · Alt: leave them behind · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Mover %1 m, %2 m junto con otros nodos en este lugar · Alt: dejarlos atrás · Mayús: por un eje · Ctrl: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>Two neighbouring nodes lie on one point, which leaves a side without length · move on, or Escape to cancel</source>
        <translation>Dos nodos vecinos están en un mismo punto, lo que deja un lado sin longitud · siga moviendo, o pulse Esc para cancelar</translation>
    </message>
    <message>
        <source>The polygon crosses itself like this and cannot be played · move on, or Escape to cancel</source>
        <translation>Así el polígono se cruza a sí mismo y no se puede jugar · siga moviendo, o pulse Esc para cancelar</translation>
    </message>
    <message>
        <source>Drag: scale the selected nodes · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · click a selected node: turn them instead</source>
        <translation>Arrastrar: escalar los nodos seleccionados · Mayús: desde el centro · Ctrl: en proporción · Alt: ajuste no/sí · clic en un nodo seleccionado: girarlos</translation>
    </message>
    <message>
        <source>Drag: turn the selected nodes · Ctrl: in steps of 15° · click a selected node: scale them instead</source>
        <translation>Arrastrar: girar los nodos seleccionados · Ctrl: en pasos de 15° · clic en un nodo seleccionado: escalarlos</translation>
    </message>
    <message>
        <source>Scaling to %1 m × %2 m · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · Escape: cancel</source>
        <translation>Escalar a %1 m × %2 m · Mayús: desde el centro · Ctrl: en proporción · Alt: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>Turning by %1° · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Girar %1° · Ctrl: en pasos de 15° · Esc: cancelar</translation>
    </message>
    <message>
        <source>Knife · drag a line across walls, lines and polygons to cut them · Shift: 15° · Ctrl: snap off/on</source>
        <translation>Cuchilla · arrastre una línea a través de muros, líneas y polígonos para cortarlos · Mayús: 15° · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>Knife · drag a line across to cut what is selected (%1) · Escape: select nothing, so as to cut everything</source>
        <translation>Cuchilla · arrastre una línea a través para cortar lo seleccionado (%1) · Esc: no seleccionar nada, para cortarlo todo</translation>
    </message>
    <message>
        <source>Nothing to cut here yet · chains are cut where the line meets them, polygons where it goes right through</source>
        <translation>Aquí aún no hay nada que cortar · las cadenas se cortan donde la línea las toca, los polígonos donde los atraviesa</translation>
    </message>
    <message>
        <source>Ship · click: put it here · drag: turn its nose · Ctrl: snap off/on · choose the tool again for the payload</source>
        <translation>Nave · clic: ponerla aquí · arrastrar: girar el morro · Ctrl: ajuste no/sí · elija otra vez la herramienta para la carga</translation>
    </message>
    <message>
        <source>Nose at %1° · Shift: 15° · release: done · Escape: cancel</source>
        <translation>Morro a %1° · Mayús: 15° · soltar: listo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Payload · click: put it here · drag: move it into place · Ctrl: snap off/on · choose the tool again for the finish</source>
        <translation>Carga · clic: ponerla aquí · arrastrar: llevarla a su sitio · Ctrl: ajuste no/sí · elija otra vez la herramienta para la meta</translation>
    </message>
    <message>
        <source>Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Carga en %1 m, %2 m · Ctrl: ajuste no/sí · soltar: listo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Finish line · drag it, or click one end and then click or type the other · Ctrl: snap off/on · choose the tool again for the ship</source>
        <translation>Línea de meta · arrástrela, o haga clic en un extremo y después haga clic o escriba el otro · Ctrl: ajuste no/sí · elija otra vez la herramienta para la nave</translation>
    </message>
    <message>
        <source>Finish line · click or release at the other end · Shift: 15° · Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel</source>
        <translation>Línea de meta · haga clic o suelte en el otro extremo · Mayús: 15° · Ctrl: ajuste no/sí · longitud %1 m, ángulo %2° · Esc: cancelar</translation>
    </message>
    <message>
        <source>The finish needs two ends: move away from the first before you click</source>
        <translation>La meta necesita dos extremos: aléjese del primero antes de hacer clic</translation>
    </message>
    <message>
        <source>Click: select · drag: rubber band · Shift + Alt (or B) + drag: lasso · Shift or Ctrl + click: add or remove · Alt or B + click: next object underneath</source>
        <translation>Clic: seleccionar · arrastrar: marco · Mayús + Alt (o B) + arrastrar: lazo · Mayús o Ctrl + clic: añadir o quitar · Alt o B + clic: siguiente objeto de debajo</translation>
    </message>
    <message>
        <source>Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band</source>
        <translation>Clic: seleccionar · arrastrar: seleccionar y mover · Mayús o Ctrl + clic: añadir o quitar · Mayús + arrastrar: marco</translation>
    </message>
    <message>
        <source>%1 selected · drag: move · click again: turn or scale · Alt or B + drag: move from anywhere · Shift or Ctrl + click: add or remove · Delete: remove · Escape: select nothing</source>
        <translation>Selección: %1 · arrastrar: mover · otro clic: girar o escalar · Alt o B + arrastrar: mover desde cualquier sitio · Mayús o Ctrl + clic: añadir o quitar · Supr: eliminar · Esc: no seleccionar nada</translation>
    </message>
    <message>
        <source>Click: select the group · double click: enter it · Ctrl + click: select by itself · drag: select and move · Shift + click: add or remove</source>
        <translation>Clic: seleccionar el grupo · doble clic: entrar en él · Ctrl + clic: seleccionar por sí solo · arrastrar: seleccionar y mover · Mayús + clic: añadir o quitar</translation>
    </message>
    <message>
        <source>%1 selected · double click: enter the group · drag: move · click again: turn or scale · Ctrl + click: select by itself · Delete: remove</source>
        <translation>Selección: %1 · doble clic: entrar en el grupo · arrastrar: mover · otro clic: girar o escalar · Ctrl + clic: seleccionar por sí solo · Supr: eliminar</translation>
    </message>
    <message>
        <source>Inside a group, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>Dentro de un grupo, selección: %1 · los clics seleccionan sus miembros · Esc, o doble clic en lo vacío: salir de él</translation>
    </message>
    <message>
        <source>Inside “%2”, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>Dentro de «%2», selección: %1 · los clics seleccionan sus miembros · Esc, o doble clic en lo vacío: salir de él</translation>
    </message>
    <message>
        <source>%1 selected · Ctrl: only what lies wholly inside · Escape: cancel</source>
        <translation>Selección: %1 · Ctrl: solo lo que queda dentro por entero · Esc: cancelar</translation>
    </message>
    <message>
        <source>Node · drag: move it alone · Alt or B + drag: move the whole object · double click: edit all nodes</source>
        <translation>Nodo · arrastrar: mover solo este · Alt o B + arrastrar: mover el objeto entero · doble clic: editar todos los nodos</translation>
    </message>
    <message>
        <source>Drag: scale · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on</source>
        <translation>Arrastrar: escalar · Mayús: desde el centro · Ctrl: mantener la proporción · Alt o B: ajuste no/sí</translation>
    </message>
    <message>
        <source>%1 × %2 m (%3 %, %4 %) · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on · Escape: cancel</source>
        <translation>%1 × %2 m (%3 %, %4 %) · Mayús: desde el centro · Ctrl: mantener la proporción · Alt o B: ajuste no/sí · Esc: cancelar</translation>
    </message>
    <message>
        <source>Drag: turn about the pivot · Shift: about the opposite corner · Ctrl: in steps of 15° · click the object: scale</source>
        <translation>Arrastrar: girar en torno al pivote · Mayús: en torno a la esquina opuesta · Ctrl: en pasos de 15° · clic en el objeto: escalar</translation>
    </message>
    <message>
        <source>Turning by %1° · Shift: about the opposite corner · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Girar %1° · Mayús: en torno a la esquina opuesta · Ctrl: en pasos de 15° · Esc: cancelar</translation>
    </message>
    <message>
        <source>Drag: move the pivot, about which the selection turns · Ctrl: snap off/on</source>
        <translation>Arrastrar: mover el pivote, en torno al cual gira la selección · Ctrl: ajuste no/sí</translation>
    </message>
    <message>
        <source>%1 selected · Alt or B: only what lies wholly inside · Escape: cancel</source>
        <translation>Selección: %1 · Alt o B: solo lo que queda dentro por entero · Esc: cancelar</translation>
    </message>
    <message>
        <source>Draw one-way walls</source>
        <translation>Dibujar muros de una cara</translation>
    </message>
    <message>
        <source>Draw two-sided walls</source>
        <translation>Dibujar líneas de dos caras</translation>
    </message>
    <message>
        <source>Draw polygon</source>
        <translation>Dibujar polígono</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>Dibujar círculo</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>Dibujar rectángulo</translation>
    </message>
    <message>
        <source>Draw moving body</source>
        <translation>Dibujar cuerpo móvil</translation>
    </message>
    <message>
        <source>Draw connector</source>
        <translation>Dibujar conector</translation>
    </message>
    <message>
        <source>Set velocity</source>
        <translation>Fijar velocidad</translation>
    </message>
    <message>
        <source>Extend chain</source>
        <translation>Alargar cadena</translation>
    </message>
    <message>
        <source>Place ship</source>
        <translation>Colocar nave</translation>
    </message>
    <message>
        <source>Place payload</source>
        <translation>Colocar carga</translation>
    </message>
    <message>
        <source>Place finish</source>
        <translation>Colocar meta</translation>
    </message>
    <message>
        <source>Reopen level</source>
        <translation>Reabrir nivel</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>Mover objeto</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Mover %n objeto</numerusform>
            <numerusform>Mover %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate object</source>
        <translation>Girar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n objects</source>
        <translation>
            <numerusform>Girar %n objeto</numerusform>
            <numerusform>Girar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale object</source>
        <translation>Escalar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n objects</source>
        <translation>
            <numerusform>Escalar %n objeto</numerusform>
            <numerusform>Escalar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip object</source>
        <translation>Voltear objeto</translation>
    </message>
    <message numerus="yes">
        <source>Flip %n objects</source>
        <translation>
            <numerusform>Voltear %n objeto</numerusform>
            <numerusform>Voltear %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Align object</source>
        <translation>Alinear objeto</translation>
    </message>
    <message numerus="yes">
        <source>Align %n objects</source>
        <translation>
            <numerusform>Alinear %n objeto</numerusform>
            <numerusform>Alinear %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Distribute object</source>
        <translation>Distribuir objeto</translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n objects</source>
        <translation>
            <numerusform>Distribuir %n objeto</numerusform>
            <numerusform>Distribuir %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Reorder object</source>
        <translation>Reordenar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Reorder %n objects</source>
        <translation>
            <numerusform>Reordenar %n objeto</numerusform>
            <numerusform>Reordenar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Group object</source>
        <translation>Agrupar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Group %n objects</source>
        <translation>
            <numerusform>Agrupar %n objeto</numerusform>
            <numerusform>Agrupar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Desagrupar</translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n groups</source>
        <translation>
            <numerusform>Desagrupar %n grupo</numerusform>
            <numerusform>Desagrupar %n grupos</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another layer</source>
        <translation>Mover objeto a otra capa</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another layer</source>
        <translation>
            <numerusform>Mover %n objeto a otra capa</numerusform>
            <numerusform>Mover %n objetos a otra capa</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another group</source>
        <translation>Mover objeto a otro grupo</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another group</source>
        <translation>
            <numerusform>Mover %n objeto a otro grupo</numerusform>
            <numerusform>Mover %n objetos a otro grupo</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename object</source>
        <translation>Renombrar objeto</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Mostrar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Show %n objects</source>
        <translation>
            <numerusform>Mostrar %n objeto</numerusform>
            <numerusform>Mostrar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Desbloquear objeto</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n objects</source>
        <translation>
            <numerusform>Desbloquear %n objeto</numerusform>
            <numerusform>Desbloquear %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Ocultar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n objects</source>
        <translation>
            <numerusform>Ocultar %n objeto</numerusform>
            <numerusform>Ocultar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Isolate object</source>
        <translation>Aislar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Isolate %n objects</source>
        <translation>
            <numerusform>Aislar %n objeto</numerusform>
            <numerusform>Aislar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Bloquear objeto</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n objects</source>
        <translation>
            <numerusform>Bloquear %n objeto</numerusform>
            <numerusform>Bloquear %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Repeat transform</source>
        <translation>Repetir transformación</translation>
    </message>
    <message numerus="yes">
        <source>Repeat transform of %n objects</source>
        <translation>
            <numerusform>Repetir transformación de %n objeto</numerusform>
            <numerusform>Repetir transformación de %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Nueva capa</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Mostrar todo</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Desbloquear todo</translation>
    </message>
    <message>
        <source>Array of one copy</source>
        <translation>Repetición de una copia</translation>
    </message>
    <message numerus="yes">
        <source>Array of %n copies</source>
        <translation>
            <numerusform>Repetición de %n copia</numerusform>
            <numerusform>Repetición de %n copias</numerusform>
        </translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>Unir cuerpos</translation>
    </message>
    <message numerus="yes">
        <source>Unite %n objects</source>
        <translation>
            <numerusform>Unir %n objeto</numerusform>
            <numerusform>Unir %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Subtract bodies</source>
        <translation>Restar cuerpos</translation>
    </message>
    <message numerus="yes">
        <source>Subtract %n objects</source>
        <translation>
            <numerusform>Restar %n objeto</numerusform>
            <numerusform>Restar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Intersect bodies</source>
        <translation>Intersecar cuerpos</translation>
    </message>
    <message numerus="yes">
        <source>Intersect %n objects</source>
        <translation>
            <numerusform>Intersecar %n objeto</numerusform>
            <numerusform>Intersecar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove points on straight sides</source>
        <translation>Quitar puntos en lados rectos</translation>
    </message>
    <message>
        <source>Merge points</source>
        <translation>Fusionar puntos</translation>
    </message>
    <message>
        <source>Turn outline round</source>
        <translation>Invertir contorno</translation>
    </message>
    <message>
        <source>Reverse wall</source>
        <translation>Invertir muro</translation>
    </message>
    <message>
        <source>Close gap</source>
        <translation>Cerrar hueco</translation>
    </message>
    <message>
        <source>Add the missing wall</source>
        <translation>Añadir el muro que falta</translation>
    </message>
    <message>
        <source>Remove what is there twice</source>
        <translation>Quitar lo que está repetido</translation>
    </message>
    <message>
        <source>Limit depth</source>
        <translation>Limitar grosor</translation>
    </message>
    <message>
        <source>Choose plain background</source>
        <translation>Elegir fondo liso</translation>
    </message>
    <message>
        <source>Move out of group</source>
        <translation>Sacar del grupo</translation>
    </message>
    <message>
        <source>Give a new key</source>
        <translation>Dar una clave nueva</translation>
    </message>
    <message>
        <source>Tag as wall</source>
        <translation>Etiquetar como muro</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Mostrarlo</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Quitarlo</translation>
    </message>
    <message>
        <source>Remove broken shapes</source>
        <translation>Quitar formas defectuosas</translation>
    </message>
    <message>
        <source>Untangle outline</source>
        <translation>Desenredar contorno</translation>
    </message>
    <message>
        <source>Move to a free place</source>
        <translation>Mover a un lugar libre</translation>
    </message>
    <message>
        <source>Fix all safe problems</source>
        <translation>Corregir todo lo seguro</translation>
    </message>
    <message>
        <source>Hide problem</source>
        <translation>Ocultar problema</translation>
    </message>
    <message>
        <source>Show hidden problem</source>
        <translation>Mostrar problema oculto</translation>
    </message>
    <message>
        <source>Reverse object</source>
        <translation>Invertir objeto</translation>
    </message>
    <message numerus="yes">
        <source>Reverse %n objects</source>
        <translation>
            <numerusform>Invertir %n objeto</numerusform>
            <numerusform>Invertir %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Take over object</source>
        <translation>Tomar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Take over %n objects</source>
        <translation>
            <numerusform>Tomar %n objeto</numerusform>
            <numerusform>Tomar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Eliminar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Eliminar %n objeto</numerusform>
            <numerusform>Eliminar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Mover nodo</translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>Mover %n nodo</numerusform>
            <numerusform>Mover %n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate nodes</source>
        <translation>Girar nodos</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n nodes</source>
        <translation>
            <numerusform>Girar %n nodo</numerusform>
            <numerusform>Girar %n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale nodes</source>
        <translation>Escalar nodos</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n nodes</source>
        <translation>
            <numerusform>Escalar %n nodo</numerusform>
            <numerusform>Escalar %n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insertar nodos</translation>
    </message>
    <message>
        <source>Delete node</source>
        <translation>Eliminar nodo</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n nodes</source>
        <translation>
            <numerusform>Eliminar %n nodo</numerusform>
            <numerusform>Eliminar %n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Eliminar segmentos</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Unir nodos</translation>
    </message>
    <message>
        <source>Break at node</source>
        <translation>Separar en nodo</translation>
    </message>
    <message numerus="yes">
        <source>Break at %n nodes</source>
        <translation>
            <numerusform>Separar en %n nodo</numerusform>
            <numerusform>Separar en %n nodos</numerusform>
        </translation>
    </message>
    <message>
        <source>Reverse part</source>
        <translation>Invertir parte</translation>
    </message>
    <message>
        <source>Straighten segments</source>
        <translation>Enderezar segmentos</translation>
    </message>
    <message>
        <source>Cut with the knife</source>
        <translation>Cortar con la cuchilla</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Duplicar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n objects</source>
        <translation>
            <numerusform>Duplicar %n objeto</numerusform>
            <numerusform>Duplicar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut object</source>
        <translation>Cortar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n objects</source>
        <translation>
            <numerusform>Cortar %n objeto</numerusform>
            <numerusform>Cortar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Cambiar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Change %n objects</source>
        <translation>
            <numerusform>Cambiar %n objeto</numerusform>
            <numerusform>Cambiar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Change level</source>
        <translation>Cambiar nivel</translation>
    </message>
    <message>
        <source>Change who touches whom</source>
        <translation>Cambiar quién toca a quién</translation>
    </message>
    <message>
        <source>Change tag</source>
        <translation>Cambiar etiqueta</translation>
    </message>
    <message>
        <source>Paste object</source>
        <translation>Pegar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n objects</source>
        <translation>
            <numerusform>Pegar %n objeto</numerusform>
            <numerusform>Pegar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Recargar del disco</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Recuperar trabajo sin guardar</translation>
    </message>
    <message>
        <source>Open backup</source>
        <translation>Abrir copia de seguridad</translation>
    </message>
    <message>
        <source>Import object</source>
        <translation>Importar objeto</translation>
    </message>
    <message numerus="yes">
        <source>Import %n objects</source>
        <translation>
            <numerusform>Importar %n objeto</numerusform>
            <numerusform>Importar %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>Añadir guía</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>Cambiar guía</translation>
    </message>
    <message>
        <source>Delete guide</source>
        <translation>Eliminar guía</translation>
    </message>
    <message>
        <source>Delete all guides</source>
        <translation>Eliminar todas las guías</translation>
    </message>
    <message>
        <source>The file “%1” cannot be read: %2.</source>
        <translation>No se puede leer el archivo «%1»: %2.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: %2. What was there before is still there.</source>
        <translation>No se puede escribir el archivo «%1»: %2. Lo que había antes sigue ahí.</translation>
    </message>
    <message>
        <source>The disk is full, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>El disco está lleno y no se puede escribir el archivo «%1». Lo que había antes sigue ahí.</translation>
    </message>
    <message>
        <source>You have used up your share of the disk, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>Ha agotado su cuota de disco y no se puede escribir el archivo «%1». Lo que había antes sigue ahí.</translation>
    </message>
    <message>
        <source>The disk with the file “%1” can only be read, so it cannot be written.</source>
        <translation>El disco del archivo «%1» es de solo lectura, así que no se puede escribir.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: there is no folder “%2” any more.</source>
        <translation>No se puede escribir el archivo «%1»: la carpeta «%2» ya no existe.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: you may not make files in the folder “%2”.</source>
        <translation>No se puede escribir el archivo «%1»: no tiene permiso para crear archivos en la carpeta «%2».</translation>
    </message>
    <message>
        <source>The file “%1” is protected: you may read it, but not write it.</source>
        <translation>El archivo «%1» está protegido: puede leerlo, pero no escribirlo.</translation>
    </message>
    <message>
        <source>The file “%1” has been changed by somebody else meanwhile, so it was not overwritten.</source>
        <translation>Entretanto, otra persona ha cambiado el archivo «%1», así que no se sobrescribió.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. What was there before is lost; save it elsewhere.</source>
        <translation>El archivo «%1» se escribió solo en parte: %2. Lo que había antes se ha perdido; guárdelo en otro sitio.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. All that it was to hold is in the file “%3”.</source>
        <translation>El archivo «%1» se escribió solo en parte: %2. Todo lo que debía contener está en el archivo «%3».</translation>
    </message>
    <message>
        <source>“%1” is not a finite number, and a file cannot hold it.</source>
        <translation>«%1» no es un número finito, y un archivo no puede contenerlo.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must lie between %3 and %4.</source>
        <translation>«%1» es %2; debe estar entre %3 y %4.</translation>
    </message>
    <message>
        <source>The mass is too small or too large to be computed with, so the body would be missing from the game.</source>
        <translation>La masa es demasiado pequeña o grande para los cálculos, así que el cuerpo faltaría en el juego.</translation>
    </message>
    <message>
        <source>The body is so small and light, or so large and heavy, that its mass or inertia cannot be computed with. It would be missing from the game.</source>
        <translation>El cuerpo es tan pequeño y ligero, o tan grande y pesado, que no se puede calcular con su masa o inercia. Faltaría en el juego.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be more than zero.</source>
        <translation>«%1» es %2; debe ser mayor que cero.</translation>
    </message>
    <message>
        <source>Select at least two bodies made of polygons, not locked.</source>
        <translation>Seleccione al menos dos cuerpos hechos de polígonos y no bloqueados.</translation>
    </message>
    <message>
        <source>“%1” is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>«%1» no está hecho solo de polígonos. Solo los polígonos se pueden unir, restar e intersecar.</translation>
    </message>
    <message>
        <source>These bodies lie too far from the origin to be combined: at most 500 km.</source>
        <translation>Estos cuerpos están demasiado lejos del origen para combinarlos: como máximo, 500 km.</translation>
    </message>
    <message>
        <source>Nothing would be left of these bodies, so they stay as they are.</source>
        <translation>De estos cuerpos no quedaría nada, así que se quedan como están.</translation>
    </message>
    <message>
        <source>The result would cross itself, so the bodies stay as they are. Move one of them a little and try again.</source>
        <translation>El resultado se cruzaría a sí mismo, así que los cuerpos se quedan como están. Mueva un poco uno de ellos e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The file starts with a byte order mark, which saving will leave out.</source>
        <translation>El archivo empieza con una marca de orden de bytes, que se omitirá al guardar.</translation>
    </message>
    <message>
        <source>“%1” is not expected here: something is wrong at this place or just before it.</source>
        <translation>Aquí no se espera «%1»: algo está mal en este lugar o justo antes.</translation>
    </message>
    <message>
        <source>A text is not closed with a quotation mark before its line ends.</source>
        <translation>Un texto no se cierra con comillas antes del final de su línea.</translation>
    </message>
    <message>
        <source>The control character %1 cannot stand here as it is.</source>
        <translation>El carácter de control %1 no puede estar aquí tal cual.</translation>
    </message>
    <message>
        <source>“%1” is not a number that a file can hold; write a finite one.</source>
        <translation>«%1» no es un número que un archivo pueda contener; escriba uno finito.</translation>
    </message>
    <message>
        <source>There is a comma before “%1” that nothing follows; leave it out.</source>
        <translation>Hay una coma antes de «%1» a la que no sigue nada; quítela.</translation>
    </message>
    <message>
        <source>The number %1 is larger than any that can be computed with.</source>
        <translation>El número %1 es mayor que cualquiera con el que se pueda calcular.</translation>
    </message>
    <message>
        <source>Lists and objects lie more than %1 deep in one another.</source>
        <translation>Hay listas y objetos anidados a más de %1 niveles.</translation>
    </message>
    <message>
        <source>The file holds more than %1 values.</source>
        <translation>El archivo contiene más de %1 valores.</translation>
    </message>
    <message>
        <source>The level is so large that it could not be saved again, so it is not opened.</source>
        <translation>El nivel es tan grande que no se podría guardar de nuevo, así que no se abre.</translation>
    </message>
    <message>
        <source>The file holds more than %1 vertices.</source>
        <translation>El archivo contiene más de %1 vértices.</translation>
    </message>
    <message>
        <source>The field “%1” is given twice.</source>
        <translation>El campo «%1» aparece dos veces.</translation>
    </message>
    <message>
        <source>This is not a level: it should be an object in braces, but is %1.</source>
        <translation>Esto no es un nivel: debería ser un objeto entre llaves, pero es %1.</translation>
    </message>
    <message>
        <source>This is not a level: the field “schema” is missing (it should be %1).</source>
        <translation>Esto no es un nivel: falta el campo «schema» (debería ser %1).</translation>
    </message>
    <message>
        <source>The level was made with a newer version (schema %1; this one reads up to %2). Please update the program.</source>
        <translation>El nivel se hizo con una versión más nueva (schema %1; esta lee hasta %2). Actualice el programa.</translation>
    </message>
    <message>
        <source>The schema %1 is not known; this version reads %2.</source>
        <translation>El schema %1 no se conoce; esta versión lee %2.</translation>
    </message>
    <message>
        <source>The field “%1” is missing.</source>
        <translation>Falta el campo «%1».</translation>
    </message>
    <message>
        <source>The field “%1” is not known here. It is kept, but does nothing.</source>
        <translation>El campo «%1» no se conoce aquí. Se conserva, pero no hace nada.</translation>
    </message>
    <message>
        <source>“%1” must be a number, not %2.</source>
        <translation>«%1» debe ser un número, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number, not %2.</source>
        <translation>«%1» debe ser un número entero, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be a number, or null for a wall without a back, not %2.</source>
        <translation>«%1» debe ser un número, o null para un muro sin dorso, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be true or false, not %2.</source>
        <translation>«%1» debe ser true o false, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be a text, not %2.</source>
        <translation>«%1» debe ser un texto, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be two numbers [x, y], not %2.</source>
        <translation>«%1» debe ser dos números [x, y], no %2.</translation>
    </message>
    <message>
        <source>“%1” must be a list in brackets, not %2.</source>
        <translation>«%1» debe ser una lista entre corchetes, no %2.</translation>
    </message>
    <message>
        <source>“%1” must hold objects in braces, not %2.</source>
        <translation>«%1» debe contener objetos entre llaves, no %2.</translation>
    </message>
    <message>
        <source>“%1” must be “all”, a list of tags or {&quot;except&quot;: a list of tags}, not %2.</source>
        <translation>«%1» debe ser «all», una lista de etiquetas o {&quot;except&quot;: una lista de etiquetas}, no %2.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be one of: %3.</source>
        <translation>«%1» es %2; debe ser uno de estos: %3.</translation>
    </message>
    <message>
        <source>There is no tag named “%1” in this level.</source>
        <translation>En este nivel no hay ninguna etiqueta llamada «%1».</translation>
    </message>
    <message>
        <source>“%1” must be eight hexadecimal digits that are not all zero, not %2.</source>
        <translation>«%1» debe ser ocho dígitos hexadecimales que no sean todos cero, no %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by the object in line %2.</source>
        <translation>La clave %1 la tiene ya el objeto de la línea %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by another object.</source>
        <translation>La clave %1 la tiene ya otro objeto.</translation>
    </message>
    <message>
        <source>There are two tags named “%1”.</source>
        <translation>Hay dos etiquetas llamadas «%1».</translation>
    </message>
    <message>
        <source>There are two tags with the index %1.</source>
        <translation>Hay dos etiquetas con el índice %1.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number from 0 to 31, not %2.</source>
        <translation>«%1» debe ser un número entero de 0 a 31, no %2.</translation>
    </message>
    <message>
        <source>A tag cannot be named “%1”: that is how a tag without a name is written.</source>
        <translation>Una etiqueta no puede llamarse «%1»: así se escribe una etiqueta sin nombre.</translation>
    </message>
    <message>
        <source>“%1” must be a color such as &quot;#4cc9f0&quot;, not %2.</source>
        <translation>«%1» debe ser un color como &quot;#4cc9f0&quot;, no %2.</translation>
    </message>
    <message>
        <source>There are %1 more problems, which are not listed.</source>
        <translation>Problemas que no se enumeran: otros %1.</translation>
    </message>
    <message>
        <source>The level has no ship. Place one, or remove payload and finish to make it a sandbox.</source>
        <translation>El nivel no tiene nave. Coloque una, o quite carga y meta para que sea una zona de pruebas.</translation>
    </message>
    <message>
        <source>The level has no payload. Place one, or remove ship and finish to make it a sandbox.</source>
        <translation>El nivel no tiene carga. Coloque una, o quite nave y meta para que sea una zona de pruebas.</translation>
    </message>
    <message>
        <source>The level has no finish. Place one, or remove ship and payload to make it a sandbox.</source>
        <translation>El nivel no tiene meta. Coloque una, o quite nave y carga para que sea una zona de pruebas.</translation>
    </message>
    <message>
        <source>There is more than one ship; only the first flies.</source>
        <translation>Hay más de una nave; solo vuela la primera.</translation>
    </message>
    <message>
        <source>There is more than one payload; only the first counts.</source>
        <translation>Hay más de una carga; solo cuenta la primera.</translation>
    </message>
    <message>
        <source>There is more than one finish; only the first counts.</source>
        <translation>Hay más de una meta; solo cuenta la primera.</translation>
    </message>
    <message>
        <source>The ship starts in touch with the object “%1” and would crash at once.</source>
        <translation>La nave empieza en contacto con el objeto «%1» y se estrellaría al instante.</translation>
    </message>
    <message>
        <source>The payload starts in touch with the object “%1”.</source>
        <translation>La carga empieza en contacto con el objeto «%1».</translation>
    </message>
    <message>
        <source>The ship starts in touch with %2 at %3; %4 m and would crash at once.</source>
        <translation>La nave empieza en contacto con %2 en %3; %4 m y se estrellaría al instante.</translation>
    </message>
    <message>
        <source>The payload starts in touch with %2 at %3; %4 m.</source>
        <translation>La carga empieza en contacto con %2 en %3; %4 m.</translation>
    </message>
    <message>
        <source>the one-way wall</source>
        <translation>el muro de una cara</translation>
    </message>
    <message>
        <source>the two-way line</source>
        <translation>la línea de dos caras</translation>
    </message>
    <message>
        <source>the polygon</source>
        <translation>el polígono</translation>
    </message>
    <message>
        <source>the circle</source>
        <translation>el círculo</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>el cuerpo</translation>
    </message>
    <message>
        <source>The body has no shape.</source>
        <translation>El cuerpo no tiene forma.</translation>
    </message>
    <message>
        <source>A chain of walls needs at least two vertices; this one has %1.</source>
        <translation>Una cadena de muros necesita al menos dos vértices; esta tiene %1.</translation>
    </message>
    <message>
        <source>All vertices of this chain of walls lie at the same point.</source>
        <translation>Todos los vértices de esta cadena de muros están en el mismo punto.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 lie at the same point: the wall between them has no length.</source>
        <translation>Los vértices %1 y %2 están en el mismo punto: el muro entre ellos no tiene longitud.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 of the polygon lie at the same point.</source>
        <translation>Los vértices %1 y %2 del polígono están en el mismo punto.</translation>
    </message>
    <message>
        <source>A polygon of %1 vertices is too large; %2 are allowed.</source>
        <translation>Un polígono de %1 vértices es demasiado grande; se admiten %2.</translation>
    </message>
    <message>
        <source>A polygon needs at least three different vertices; this one has %1.</source>
        <translation>Un polígono necesita al menos tres vértices distintos; este tiene %1.</translation>
    </message>
    <message>
        <source>The polygon crosses itself: the sides from vertex %1 and from vertex %2 meet.</source>
        <translation>El polígono se cruza a sí mismo: los lados desde el vértice %1 y desde el vértice %2 se tocan.</translation>
    </message>
    <message>
        <source>The polygon crosses itself.</source>
        <translation>El polígono se cruza a sí mismo.</translation>
    </message>
    <message>
        <source>All vertices of the polygon lie on one line: it encloses nothing.</source>
        <translation>Todos los vértices del polígono están en una línea: no encierra nada.</translation>
    </message>
    <message>
        <source>The vertices of the polygon run clockwise; they are taken the other way round.</source>
        <translation>Los vértices del polígono van en sentido horario; se toman al revés.</translation>
    </message>
    <message>
        <source>It belongs to the group %1, which does not exist; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Pertenece al grupo %1, que no existe; se muestra en lo más alto. Póngalo en otro grupo, o en lo más alto.</translation>
    </message>
    <message>
        <source>It belongs to the object %1, which is not a group; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Pertenece al objeto %1, que no es un grupo; se muestra en lo más alto. Póngalo en otro grupo, o en lo más alto.</translation>
    </message>
    <message>
        <source>It is in the group %1, which is in it, directly or not; it is shown at the top. Put one of them to the top.</source>
        <translation>Está en el grupo %1, que a su vez está en él, directamente o no; se muestra en lo más alto. Ponga uno de ellos en lo más alto.</translation>
    </message>
    <message>
        <source>A layer is in another group. Layers are at the top: put it there, or make it an ordinary group.</source>
        <translation>Una capa está en otro grupo. Las capas van en lo más alto: póngala ahí, o hágala un grupo normal.</translation>
    </message>
    <message>
        <source>It is hidden in the editor, but takes part in the game.</source>
        <translation>Está oculto en el editor, pero participa en el juego.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which does not exist.</source>
        <translation>El extremo «%1» del conector es el objeto %2, que no existe.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which is not a body.</source>
        <translation>El extremo «%1» del conector es el objeto %2, que no es un cuerpo.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same object.</source>
        <translation>Los dos extremos del conector están en el mismo objeto.</translation>
    </message>
    <message>
        <source>A stiffness of %1 N/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Una rigidez de %1 N/m es demasiada para los subpasos: el muelle puede temblar. Bastarían unos %2 subpasos.</translation>
    </message>
    <message>
        <source>A damping of %1 N s/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Una amortiguación de %1 N s/m es demasiada para los subpasos: el muelle puede temblar. Bastarían unos %2 subpasos.</translation>
    </message>
    <message>
        <source>The tags of this body are such that nothing can touch it.</source>
        <translation>Las etiquetas de este cuerpo son tales que nada puede tocarlo.</translation>
    </message>
    <message>
        <source>Points that lie on straight sides and do nothing: %1.</source>
        <translation>Puntos que están en lados rectos y no hacen nada: %1.</translation>
    </message>
    <message>
        <source>This wall is solid on the other side than the walls it goes on from: the ship can fly out through it. Reverse it.</source>
        <translation>Este muro es sólido por el lado contrario que los muros a los que sigue: la nave puede salir volando a través de él. Inviértalo.</translation>
    </message>
    <message>
        <source>This wall and the one it goes on from are solid on different sides. Reverse one of them.</source>
        <translation>Este muro y aquel al que sigue son sólidos por lados distintos. Invierta uno de ellos.</translation>
    </message>
    <message>
        <source>The two ends of this chain of walls are %1 mm apart, so it is not closed.</source>
        <translation>Los dos extremos de esta cadena de muros distan %1 mm, así que no está cerrada.</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to “%1”.</source>
        <translation>Hay un hueco de %5 mm hasta «%1».</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to %2 at %3; %4 m.</source>
        <translation>Hay un hueco de %5 mm hasta %2 en %3; %4 m.</translation>
    </message>
    <message>
        <source>This wall lies exactly on “%1”, which does the same.</source>
        <translation>Este muro está justo sobre «%1», que hace lo mismo.</translation>
    </message>
    <message>
        <source>This wall lies exactly on %2 at %3; %4 m, which does the same.</source>
        <translation>Este muro está justo sobre %2 en %3; %4 m, que hace lo mismo.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of “%1”: %5.</source>
        <translation>Muros que están justo sobre los de «%1»: %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of %2 at %3; %4 m: %5.</source>
        <translation>Muros que están justo sobre los que tiene %2 en %3; %4 m: %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on others of the same chain: %1.</source>
        <translation>Muros que están justo sobre otros de la misma cadena: %1.</translation>
    </message>
    <message>
        <source>It lies exactly on “%1”, which is the same.</source>
        <translation>Está justo sobre «%1», que es igual.</translation>
    </message>
    <message>
        <source>It lies exactly on %2 at %3; %4 m, which is the same.</source>
        <translation>Está justo sobre %2 en %3; %4 m, que es igual.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but what is fastest here may move %2 m between two looks at what it touches, and may get through. Make it deeper, or raise the iterations.</source>
        <translation>El muro tiene %1 m de grosor, pero lo más rápido de aquí puede moverse %2 m entre dos comprobaciones de contacto y puede atravesarlo. Hágalo más grueso, o suba las iteraciones.</translation>
    </message>
    <message>
        <source>The wall has no back, so what is solid behind it reaches into the free space %1 m behind. Give it a depth of no more than that.</source>
        <translation>El muro no tiene dorso, así que lo sólido tras él llega al espacio libre %1 m más atrás. Dele un grosor que no pase de ahí.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but %2 m behind it there is free space, into which it reaches. Give it a depth of no more than that.</source>
        <translation>El muro tiene %1 m de grosor, pero %2 m más atrás hay espacio libre, al que llega. Dele un grosor que no pase de ahí.</translation>
    </message>
    <message>
        <source>The wall has no back, so all the free space behind it counts as solid. Give it a depth.</source>
        <translation>El muro no tiene dorso, así que todo el espacio libre tras él cuenta como sólido. Dele un grosor.</translation>
    </message>
    <message>
        <source>The ship starts outside of the cave that the payload is in.</source>
        <translation>La nave empieza fuera de la cueva en que está la carga.</translation>
    </message>
    <message>
        <source>The payload is outside of the cave that the ship starts in.</source>
        <translation>La carga está fuera de la cueva en que empieza la nave.</translation>
    </message>
    <message>
        <source>The finish is outside of the cave that the ship starts in.</source>
        <translation>La meta está fuera de la cueva en que empieza la nave.</translation>
    </message>
    <message>
        <source>Both ends of the finish lie at the same point, so nothing can cross it.</source>
        <translation>Los dos extremos de la meta están en el mismo punto, así que nada puede cruzarla.</translation>
    </message>
    <message>
        <source>The payload starts on the finish.</source>
        <translation>La carga empieza sobre la meta.</translation>
    </message>
    <message>
        <source>Gravity is too strong: the ship weighs %1 N, and its thrust is %2 N.</source>
        <translation>La gravedad es demasiado fuerte: la nave pesa %1 N, y su propulsión es de %2 N.</translation>
    </message>
    <message>
        <source>Ship and payload together weigh %1 N; the ship&apos;s thrust of %2 N cannot lift them.</source>
        <translation>Nave y carga juntas pesan %1 N; la propulsión de la nave, de %2 N, no puede levantarlas.</translation>
    </message>
    <message>
        <source>There is no background named “%1”; it is shown as a plain one.</source>
        <translation>No hay ningún fondo llamado «%1»; se muestra uno liso.</translation>
    </message>
    <message>
        <source>The ship flies through this wall: it does not have the tag “%1”.</source>
        <translation>La nave atraviesa este muro: no tiene la etiqueta «%1».</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through “%1”.</source>
        <translation>Está hecho solo de muros, y los muros nunca chocan con muros: cae a través de «%1».</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through %2 at %3; %4 m.</source>
        <translation>Está hecho solo de muros, y los muros nunca chocan con muros: al caer atraviesa %2 en %3; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out through this wall: it is solid on the wrong side. Reverse it.</source>
        <translation>La nave puede salir por este muro: es sólido por el lado equivocado. Inviértalo.</translation>
    </message>
    <message>
        <source>The ship can get out through this chain: all its %1 walls are solid on the wrong side. Reverse it.</source>
        <translation>La nave puede salir por esta cadena: sus %1 muros son sólidos por el lado equivocado. Inviértala.</translation>
    </message>
    <message>
        <source>The ship can get out through edge %1 of this chain: it is solid on the wrong side.</source>
        <translation>La nave puede salir por la arista %1 de esta cadena: es sólida por el lado equivocado.</translation>
    </message>
    <message>
        <source>The ship can get out: %1 walls, of which this is one, are solid on the wrong side.</source>
        <translation>La nave puede salir: %1 muros, entre ellos este, son sólidos por el lado equivocado.</translation>
    </message>
    <message>
        <source>The ship can get out: this chain is not closed, its ends are %1 m apart.</source>
        <translation>La nave puede salir: esta cadena no está cerrada, sus extremos distan %1 m.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %1 m is missing between two ends of this object.</source>
        <translation>La nave puede salir: falta un muro de %1 m entre dos extremos de este objeto.</translation>
    </message>
    <message>
        <source>The ship can get out: there is an opening of %1 m in this object.</source>
        <translation>La nave puede salir: hay una abertura de %1 m en este objeto.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of “%1”.</source>
        <translation>La nave puede salir: falta un muro de %5 m entre el extremo de este y el de «%1».</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of %2 at %3; %4 m.</source>
        <translation>La nave puede salir: falta un muro de %5 m entre el extremo de este y el de %2 en %3; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before “%1”.</source>
        <translation>La nave puede salir: este muro termina a %5 m de «%1».</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before %2 at %3; %4 m.</source>
        <translation>La nave puede salir: este muro termina a %5 m de %2 en %3; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out between this and “%1”: they are %5 m apart.</source>
        <translation>La nave puede salir entre este y «%1»: distan %5 m.</translation>
    </message>
    <message>
        <source>The ship can get out between this and %2 at %3; %4 m: they are %5 m apart.</source>
        <translation>La nave puede salir entre este y %2 en %3; %4 m: distan %5 m.</translation>
    </message>
    <message>
        <source>“%1” is not a mass that a body can have.</source>
        <translation>«%1» no es una masa que un cuerpo pueda tener.</translation>
    </message>
    <message>
        <source>The body has a shape that cannot be simulated.</source>
        <translation>El cuerpo tiene una forma que no se puede simular.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is not in the world.</source>
        <translation>El extremo «%1» del conector no está en el mundo.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same body.</source>
        <translation>Los dos extremos del conector están en el mismo cuerpo.</translation>
    </message>
    <message>
        <source>These tags came along, as the level did not have them: %1.</source>
        <translation>Se añadieron estas etiquetas, que el nivel no tenía: %1.</translation>
    </message>
    <message>
        <source>The tag “%1” is called “%2” in this level.</source>
        <translation>La etiqueta «%1» se llama «%2» en este nivel.</translation>
    </message>
    <message>
        <source>All 32 tags of this level are in use, so these were left off: %1.</source>
        <translation>Las 32 etiquetas de este nivel están en uso, así que se omitieron estas: %1.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Falta un número.</translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation>Falta algo al final.</translation>
    </message>
    <message>
        <source>“%1” cannot stand where it is.</source>
        <translation>«%1» no puede estar donde está.</translation>
    </message>
    <message>
        <source>“%1” is neither a unit nor a function; try 2*pi/3, sqrt(2), 20 cm or +=0.5.</source>
        <translation>«%1» no es ni una unidad ni una función; pruebe 2*pi/3, sqrt(2), 20 cm o +=0.5.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Falta cerrar un paréntesis.</translation>
    </message>
    <message>
        <source>“%1” has another number of values; they are parted by semicolons.</source>
        <translation>«%1» tiene otro número de valores; se separan con punto y coma.</translation>
    </message>
    <message>
        <source>This is too long or too deeply nested.</source>
        <translation>Esto es demasiado largo o tiene demasiados niveles.</translation>
    </message>
    <message>
        <source>Nothing can be divided by zero.</source>
        <translation>Nada se puede dividir entre cero.</translation>
    </message>
    <message>
        <source>The result is too large, or is no number.</source>
        <translation>El resultado es demasiado grande, o no es un número.</translation>
    </message>
    <message>
        <source>These units do not go together.</source>
        <translation>Estas unidades no encajan entre sí.</translation>
    </message>
    <message>
        <source>The result must be a plain number or one in %1.</source>
        <translation>El resultado debe ser un número solo o uno en %1.</translation>
    </message>
    <message>
        <source>This is a plain number without a unit.</source>
        <translation>Esto es un número solo, sin unidad.</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>vértice</translation>
    </message>
    <message>
        <source>vertex of %1</source>
        <translation>vértice de %1</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>center of %1</source>
        <translation>centro de %1</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>anclaje</translation>
    </message>
    <message>
        <source>anchor on %1</source>
        <translation>anclaje en %1</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>intersección</translation>
    </message>
    <message>
        <source>intersection with %1</source>
        <translation>intersección con %1</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>punto medio</translation>
    </message>
    <message>
        <source>midpoint of %1</source>
        <translation>punto medio de %1</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>perpendicular</translation>
    </message>
    <message>
        <source>perpendicular to %1</source>
        <translation>perpendicular a %1</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>borde</translation>
    </message>
    <message>
        <source>edge of %1</source>
        <translation>borde de %1</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>guía</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>guía %1</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>alineado</translation>
    </message>
    <message>
        <source>in line with %1</source>
        <translation>en línea con %1</translation>
    </message>
    <message>
        <source>multiple of 15°</source>
        <translation>múltiplo de 15°</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>cuadrícula</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 y %2</translation>
    </message>
    <message>
        <source>once</source>
        <translation>una vez</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n veces</numerusform>
            <numerusform>%n veces</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in line %2</source>
        <translation>%1, en la línea %2</translation>
    </message>
    <message>
        <source>%1, in lines %2</source>
        <translation>%1, en las líneas %2</translation>
    </message>
    <message>
        <source>What drawings within the drawing hide beyond their borders is there as well (%4).</source>
        <translation>Lo que los dibujos dentro del dibujo ocultan más allá de sus bordes también está (%4).</translation>
    </message>
    <message>
        <source>The width of wide strokes was not taken over: they are walls without thickness (%4). “Stroke to Path” of Inkscape makes areas of them.</source>
        <translation>La anchura de los trazos anchos no se ha tomado: son muros sin grosor (%4). «Borde a trayecto» de Inkscape los convierte en áreas.</translation>
    </message>
    <message>
        <source>They touch: “%1” and “%2” are in contact.</source>
        <translation>Se tocan: «%1» y «%2» están en contacto.</translation>
    </message>
    <message>
        <source>Both are the same body, which does not collide with itself.</source>
        <translation>Ambos son el mismo cuerpo, que no colisiona consigo mismo.</translation>
    </message>
    <message>
        <source>“%1” is switched off, so it touches nothing.</source>
        <translation>«%1» está desactivado, así que no toca nada.</translation>
    </message>
    <message>
        <source>Neither is moved by forces: “%1” and “%2” pass through each other unless one of them is dynamic.</source>
        <translation>A ninguno lo mueven las fuerzas: «%1» y «%2» se atraviesan, salvo que uno de ellos sea dinámico.</translation>
    </message>
    <message>
        <source>“%2” has no tags, and what has none is touched by nothing.</source>
        <translation>«%2» no tiene etiquetas, y nada toca lo que no las tiene.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3.</source>
        <translation>«%1» no toca lo que «%2» es: %3.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3. Nor does “%2” touch what “%1” is.</source>
        <translation>«%1» no toca lo que «%2» es: %3. Tampoco «%2» toca lo que «%1» es.</translation>
    </message>
    <message>
        <source>“%3” connects “%1” and “%2”, and bodies that it connects do not collide.</source>
        <translation>«%3» une «%1» y «%2», y los cuerpos que une no colisionan.</translation>
    </message>
    <message>
        <source>The tow rope connects “%1” and “%2”, which therefore do not collide.</source>
        <translation>La cuerda de remolque une «%1» y «%2», que por eso no colisionan.</translation>
    </message>
    <message>
        <source>“%1” is intangible: it would be felt, but stops nothing.</source>
        <translation>«%1» es intangible: se notaría, pero no detiene nada.</translation>
    </message>
    <message>
        <source>“%1” is intangible: “%2” touches it and is felt, but nothing stops it.</source>
        <translation>«%1» es intangible: «%2» lo toca y se nota, pero nada lo detiene.</translation>
    </message>
    <message>
        <source>Both are nothing but walls, and walls pass through each other.</source>
        <translation>Ambos son solo muros, y los muros se atraviesan.</translation>
    </message>
    <message>
        <source>“%1” and “%2” may collide, but are %3 m apart.</source>
        <translation>«%1» y «%2» pueden colisionar, pero están a %3 m de distancia.</translation>
    </message>
    <message>
        <source>“%1” and “%2” overlap, and collide as soon as the simulation goes on.</source>
        <translation>«%1» y «%2» se solapan y colisionarán en cuanto siga la simulación.</translation>
    </message>
    <message>
        <source>Let “%1” touch “%2”</source>
        <translation>Dejar que «%1» toque «%2»</translation>
    </message>
    <message>
        <source>Give “%1” the tag “%2”</source>
        <translation>Dar a «%1» la etiqueta «%2»</translation>
    </message>
    <message>
        <source>Make “%1” tangible</source>
        <translation>Hacer tangible «%1»</translation>
    </message>
    <message>
        <source>Let the bodies of “%1” collide</source>
        <translation>Dejar que choquen los cuerpos de «%1»</translation>
    </message>
    <message>
        <source>Back to before the run</source>
        <translation>Volver a antes de la ejecución</translation>
    </message>
    <message>
        <source>Keep change of the level</source>
        <translation>Conservar cambio del nivel</translation>
    </message>
    <message>
        <source>Keep new object</source>
        <translation>Conservar objeto nuevo</translation>
    </message>
    <message>
        <source>Keep deletion</source>
        <translation>Conservar eliminación</translation>
    </message>
    <message>
        <source>Keep move</source>
        <translation>Conservar movimiento</translation>
    </message>
    <message>
        <source>Keep tags</source>
        <translation>Conservar etiquetas</translation>
    </message>
    <message>
        <source>Keep order</source>
        <translation>Conservar orden</translation>
    </message>
    <message>
        <source>Keep change</source>
        <translation>Conservar cambio</translation>
    </message>
    <message>
        <source>There is no bug capsule in the text.</source>
        <translation>En el texto no hay ninguna cápsula de error.</translation>
    </message>
    <message>
        <source>The bug capsule was made with a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>La cápsula de error se hizo con una versión más nueva (%1; esta lee hasta %2). Actualice el programa.</translation>
    </message>
    <message>
        <source>The run is longer than a bug capsule may be: %1 updates.</source>
        <translation>La ejecución es más larga de lo que puede ser una cápsula de error: %1 actualizaciones.</translation>
    </message>
    <message>
        <source>The run has ended, and nothing of it is left.</source>
        <translation>La ejecución ha terminado y no queda nada de ella.</translation>
    </message>
    <message>
        <source>Edits of the run</source>
        <translation>Cambios durante la ejecución</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n changes</source>
        <translation>
            <numerusform>Conservar %n cambio</numerusform>
            <numerusform>Conservar %n cambios</numerusform>
        </translation>
    </message>
    <message>
        <source>The wall is solid inside, where ship or payload start: it was drawn clockwise. Reverse it to make a cave of the rock.</source>
        <translation>La pared es sólida por dentro, donde empiezan la nave o la carga: se dibujó en sentido horario. Inviértala para hacer de la roca una cueva.</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>No se puede abrir %1.</translation>
    </message>
    <message>
        <source>The file is not sound XML: line %1, column %2: %3</source>
        <translation>El archivo no es XML correcto: línea %1, columna %2: %3</translation>
    </message>
    <message>
        <source>Elements of the file lie more than %1 deep in one another. Ungroup some of them, and try again.</source>
        <translation>Hay elementos del archivo anidados a más de %1 niveles. Desagrupe algunos e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>The file draws more than %1 pieces, which is more than can be imported. Take out what the level does not need, and try again.</source>
        <translation>El archivo dibuja más de %1 piezas, más de las que se pueden importar. Quite lo que el nivel no necesita e inténtelo de nuevo.</translation>
    </message>
    <message>
        <source>Drag: move · Shift + drag: move the pivot, about which it turns</source>
        <translation>Arrastrar: mover · Mayús + arrastrar: mover el pivote, alrededor del cual gira</translation>
    </message>
    <message>
        <source>The file “%1” is too large: at most %2 can be read.</source>
        <translation>El archivo «%1» es demasiado grande: se pueden leer %2 como máximo.</translation>
    </message>
    <message>
        <source>This is too large: at most %1 can be read.</source>
        <translation>Es demasiado grande: se pueden leer %1 como máximo.</translation>
    </message>
    <message>
        <source>The file is empty. Fetch it again, or take a copy of it from a backup.</source>
        <translation>El archivo está vacío. Obténgalo de nuevo o tome una copia de seguridad.</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8 from here on: it is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Desde aquí el archivo no es texto UTF-8: está dañado o es otra cosa. Obténgalo de nuevo o tome una copia de seguridad.</translation>
    </message>
    <message>
        <source>There is a zero byte here, which text cannot hold: the file is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Aquí hay un byte cero, que un texto no puede contener: el archivo está dañado o es otra cosa. Obténgalo de nuevo o tome una copia de seguridad.</translation>
    </message>
    <message>
        <source>The file ends too early: a bracket, a brace or a quotation mark is not closed. Perhaps it was not copied as a whole; fetch it again.</source>
        <translation>El archivo termina demasiado pronto: falta cerrar un corchete, una llave o unas comillas. Quizá no se copió entero; obténgalo de nuevo.</translation>
    </message>
    <message>
        <source>Neither of the two bodies can be moved by the connector; one should be dynamic.</source>
        <translation>El conector no puede mover ninguno de los dos cuerpos; uno debería ser dinámico.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
    <message>
        <source>This is not a recorded flight. “Save Flight…” makes one of a run.</source>
        <translation>No es un vuelo grabado. «Guardar vuelo…» crea uno a partir de una ejecución.</translation>
    </message>
    <message>
        <source>Line %2: “%1” is missing or not what a recorded flight has there. Correct it in a text editor, or save the flight again.</source>
        <translation>Línea %2: «%1» falta o no es lo que un vuelo grabado tiene ahí. Corríjalo en un editor de texto o guarde el vuelo de nuevo.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is none that a recorded flight has. Take it out; if a newer version wrote it, update the program.</source>
        <translation>Línea %2: un vuelo grabado no tiene el campo «%1». Quítelo; si lo escribió una versión más nueva, actualice el programa.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is given a second time. Take one of the two out.</source>
        <translation>Línea %2: el campo «%1» aparece por segunda vez. Quite uno de los dos.</translation>
    </message>
    <message>
        <source>The flight was saved by a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>El vuelo lo guardó una versión más nueva (%1; esta lee hasta %2). Actualice el programa.</translation>
    </message>
    <message>
        <source>The flight is longer than %1 updates, so it cannot be flown again. Save a shorter one.</source>
        <translation>El vuelo dura más de %1 actualizaciones, así que no se puede repetir. Guarde uno más corto.</translation>
    </message>
    <message>
        <source>The bug capsule is not whole: its last line is missing. Copy it again, from its first line to its last.</source>
        <translation>La cápsula de error no está completa: falta su última línea. Cópiela de nuevo, de la primera línea a la última.</translation>
    </message>
    <message>
        <source>The bug capsule has been changed or damaged on its way. Copy it again where it was made.</source>
        <translation>La cápsula de error se cambió o se dañó por el camino. Cópiela de nuevo donde se hizo.</translation>
    </message>
    <message>
        <source>The bug capsule cannot be understood at “%1”. Ask for a new one.</source>
        <translation>La cápsula de error no se entiende en «%1». Pida una nueva.</translation>
    </message>
    <message>
        <source>The level in the bug capsule cannot be read, so ask for a new one. Line %1 of it: %2</source>
        <translation>El nivel de la cápsula de error no se puede leer; pida una nueva. Su línea %1: %2</translation>
    </message>
    <message>
        <source>The run is larger than a bug capsule may be: %1.</source>
        <translation>La ejecución es mayor de lo que puede ser una cápsula de error: %1.</translation>
    </message>
    <message>
        <source>there is no such file; it may have been moved</source>
        <translation>ese archivo no existe; quizá se haya movido</translation>
    </message>
    <message>
        <source>you do not have the permission; ask its owner for it</source>
        <translation>no tiene permiso; pídaselo a su propietario</translation>
    </message>
    <message>
        <source>the system does not permit it</source>
        <translation>el sistema no lo permite</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es una carpeta</translation>
    </message>
    <message>
        <source>what should be its folder is a file</source>
        <translation>lo que debería ser su carpeta es un archivo</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>no es un archivo normal</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>su nombre es demasiado largo</translation>
    </message>
    <message>
        <source>the disk does not answer as it should; copy what it holds</source>
        <translation>el disco no responde como debería; copie lo que contiene</translation>
    </message>
    <message>
        <source>no place could be made there</source>
        <translation>no se pudo crear un lugar allí</translation>
    </message>
    <message>
        <source>Change “%1” of the level</source>
        <translation>Cambiar «%1» del nivel</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Cambiar «%1»</translation>
    </message>
    <message numerus="yes">
        <source>Change “%1” of %n objects</source>
        <translation>
            <numerusform>Cambiar «%1» de %n objeto</numerusform>
            <numerusform>Cambiar «%1» de %n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>“%2” is on its way through a one-way wall of “%1”, from %3; %4 to %5; %6: it came from behind, and touches nothing until all of it is in front.</source>
        <translation>«%2» está atravesando un muro de una cara de «%1», de %3; %4 a %5; %6: vino por detrás y no toca nada hasta que esté entero delante.</translation>
    </message>
    <message>
        <source>“%2” is behind a one-way wall of “%1”, from %3; %4 to %5; %6, which is open from there.</source>
        <translation>«%2» está detrás de un muro de una cara de «%1», de %3; %4 a %5; %6, que está abierto desde allí.</translation>
    </message>
    <message>
        <source>1 node selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Escape: select none</source>
        <translation>1 nodo seleccionado · arrastrar: mover · flechas: empujar · Supr: eliminar · Mayús+B: cortar · Esc: no seleccionar nada</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · release: done · Escape: cancel</source>
        <translation>Nodos seleccionados: %1 · soltar: listo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · draw around the nodes · release: done · Escape: cancel</source>
        <translation>Nodos seleccionados: %1 · rodear los nodos · soltar: listo · Esc: cancelar</translation>
    </message>
    <message>
        <source>Cuts: %1 · release: cut · Shift: 15° · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Cortes: %1 · soltar: cortar · Mayús: 15° · Ctrl: ajuste sí/no · Esc: cancelar</translation>
    </message>
    <message>
        <source>Pivot at %1; %2 m · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Pivote en %1; %2 m · Ctrl: ajuste sí/no · Esc: cancelar</translation>
    </message>
    <message>
        <source>Locked: clicks and drags go past it</source>
        <translation>Bloqueado: los clics y arrastres pasan de largo</translation>
    </message>
    <message>
        <source>%1 selected · locked, so nothing changes it · Escape: select nothing</source>
        <translation>%1 seleccionado(s) · bloqueado, nada lo cambia · Esc: no seleccionar nada</translation>
    </message>
    <message>
        <source>A body without a name is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>Un cuerpo sin nombre no consta solo de polígonos. Solo los polígonos se pueden unir, restar e intersecar.</translation>
    </message>
</context>
<context>
    <name>spacetow::ArrayBar</name>
    <message>
        <source>Copies</source>
        <translation>Copias</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Turn copies</source>
        <translation>Girar copias</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Aplicar</translation>
    </message>
    <message>
        <source>Make the copies (Enter)</source>
        <translation>Hacer las copias (Intro)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Make no copies (Escape)</source>
        <translation>No hacer copias (Esc)</translation>
    </message>
    <message>
        <source>Radial array</source>
        <translation>Repetición radial</translation>
    </message>
    <message>
        <source>Linear array</source>
        <translation>Repetición lineal</translation>
    </message>
    <message>
        <source>Center x</source>
        <translation>Centro x</translation>
    </message>
    <message>
        <source>Step x</source>
        <translation>Paso x</translation>
    </message>
    <message>
        <source>y</source>
        <comment>of a center or step</comment>
        <translation>y</translation>
    </message>
    <message>
        <source>Select what is to be copied.</source>
        <translation>Seleccione lo que se va a copiar.</translation>
    </message>
    <message>
        <source>Of a ship, a payload and a finish a level has one: there is nothing to copy.</source>
        <translation>Un nivel tiene una sola nave, una carga y una meta: no hay nada que copiar.</translation>
    </message>
    <message>
        <source>That would be %1 objects; an array may have %2. Make fewer copies.</source>
        <translation>Serían %1 objetos; una repetición puede tener %2. Haga menos copias.</translation>
    </message>
</context>
<context>
    <name>spacetow::Canvas</name>
    <message>
        <source>Drawing board</source>
        <translation>Lienzo</translation>
    </message>
    <message>
        <source>Drawing board, running</source>
        <translation>Lienzo, en marcha</translation>
    </message>
</context>
<context>
    <name>spacetow::ColorField</name>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>spacetow::DifferencePanel</name>
    <message>
        <source>&amp;Compare With…</source>
        <translation>&amp;Comparar con…</translation>
    </message>
    <message>
        <source>Ta&amp;ke Over</source>
        <translation>&amp;Tomar</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>T&amp;erminar</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Diferencias</translation>
    </message>
    <message>
        <source>Makes the selected objects as they are in the other level</source>
        <translation>Dejar los objetos seleccionados como están en el otro nivel</translation>
    </message>
    <message>
        <source>Ends comparing; the level stays as it is</source>
        <translation>Terminar la comparación; el nivel queda como está</translation>
    </message>
    <message>
        <source>Nothing is compared. Choose a level file to see what is different from it.</source>
        <translation>No se compara nada. Elija un archivo de nivel para ver en qué difiere.</translation>
    </message>
    <message>
        <source>Comparing with %1…</source>
        <translation>Comparando con %1…</translation>
    </message>
    <message>
        <source>Nothing is different from %1.</source>
        <translation>No hay diferencias con %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n differences from %1</source>
        <translation>
            <numerusform>%n diferencia con %1</numerusform>
            <numerusform>%n diferencias con %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::DiskChanges</name>
    <message>
        <source>%1 is no longer there: it was deleted, moved or renamed. Your level is still here.</source>
        <translation>%1 ya no está ahí: se eliminó, movió o renombró. Su nivel sigue aquí.</translation>
    </message>
    <message>
        <source>Save Again</source>
        <translation>Guardar otra vez</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Guardar como…</translation>
    </message>
    <message>
        <source>%1 was changed by another program and has been loaded anew. Undo takes that back.</source>
        <translation>Otro programa cambió %1 y se ha cargado de nuevo. Con Deshacer se vuelve atrás.</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and you have changed it here.</source>
        <translation>Otro programa cambió %1, y usted lo ha cambiado aquí.</translation>
    </message>
    <message>
        <source>%1 was changed by another program and cannot be read any more. Your level is still here.</source>
        <translation>Otro programa cambió %1 y ya no se puede leer. Su nivel sigue aquí.</translation>
    </message>
    <message>
        <source>Not saved: %1 was changed by another program since you opened it, and saving would overwrite that.</source>
        <translation>No guardado: otro programa ha cambiado %1 desde que usted lo abrió, y al guardar se sobrescribiría.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Sobrescribir</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recargar</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Conservar el mío</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
</context>
<context>
    <name>spacetow::EntryBox</name>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
</context>
<context>
    <name>spacetow::Exchange</name>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>No hay memoria suficiente para una imagen de este tamaño.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Drawings and maps (*.svg *.tmx *.tmj *.json);;All files (*)</source>
        <translation>Dibujos y mapas (*.svg *.tmx *.tmj *.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>PNG pictures (*.png);;SVG drawings (*.svg)</source>
        <translation>Imágenes PNG (*.png);;Dibujos SVG (*.svg)</translation>
    </message>
    <message>
        <source>%1 was imported as a whole.</source>
        <translation>Se ha importado %1 por completo.</translation>
    </message>
    <message>
        <source>%1 was imported, but:</source>
        <translation>Se ha importado %1, pero:</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>The picture was written to %1.</source>
        <translation>La imagen se ha guardado en %1.</translation>
    </message>
    <message>
        <source>The screenshot was written to %1.</source>
        <translation>La captura se ha guardado en %1.</translation>
    </message>
    <message>
        <source>%1 was not imported.</source>
        <translation>%1 no se importó.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExplainPanel</name>
    <message>
        <source>What</source>
        <translation>Qué</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Cuánto</translation>
    </message>
    <message>
        <source>Explanation of the selection</source>
        <translation>Explicación de la selección</translation>
    </message>
    <message>
        <source>Everything. Select one object to see what moves it, or two to hear why they do not collide.</source>
        <translation>Todo. Seleccione un objeto para ver qué lo mueve, o dos para saber por qué no colisionan.</translation>
    </message>
    <message>
        <source>Why do these two not collide?</source>
        <translation>¿Por qué no colisionan estos dos?</translation>
    </message>
    <message>
        <source>Select one object, or two.</source>
        <translation>Seleccione un objeto, o dos.</translation>
    </message>
    <message>
        <source>“%1” is not part of the simulation.</source>
        <translation>«%1» no forma parte de la simulación.</translation>
    </message>
    <message>
        <source>At least one of them is no body in the simulation.</source>
        <translation>Al menos uno de ellos no es un cuerpo de la simulación.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExportBar</name>
    <message>
        <source>Export picture</source>
        <translation>Exportar imagen</translation>
    </message>
    <message>
        <source>Whole level</source>
        <translation>Nivel entero</translation>
    </message>
    <message>
        <source>What is in view</source>
        <translation>Lo que se ve</translation>
    </message>
    <message>
        <source>What of the level the picture shows</source>
        <translation>Qué parte del nivel muestra la imagen</translation>
    </message>
    <message>
        <source>Pixels of the picture for a metre of the level.</source>
        <translation>Píxeles de la imagen por metro del nivel.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparente</translation>
    </message>
    <message>
        <source>Leave the ground of the picture out</source>
        <translation>Dejar fuera el fondo de la imagen</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Cuadrícula</translation>
    </message>
    <message>
        <source>Draw the grid as well</source>
        <translation>Dibujar también la cuadrícula</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportar…</translation>
    </message>
    <message>
        <source>Choose a file, PNG or SVG (Enter)</source>
        <translation>Elegir un archivo, PNG o SVG (Intro)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Write no picture (Escape)</source>
        <translation>No guardar ninguna imagen (Esc)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 píxeles</translation>
    </message>
    <message>
        <source>There is nothing to be seen, or the picture would be too large: at most 16,384 pixels a side and 67 million in all. Choose another scale.</source>
        <translation>No hay nada que ver, o la imagen sería demasiado grande: como máximo 16&#xa0;384 píxeles por lado y 67 millones en total. Elija otra escala.</translation>
    </message>
</context>
<context>
    <name>spacetow::Finder</name>
    <message>
        <source>Find actions, levels, objects and problems</source>
        <translation>Buscar acciones, niveles, objetos y problemas</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Encontrado</translation>
    </message>
    <message>
        <source>&gt; actions · / levels · @ objects · ! problems · Enter: take · Esc: close</source>
        <translation>&gt; acciones · / niveles · @ objetos · ! problemas · Intro: tomar · Esc: cerrar</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Nada se llama así.</translation>
    </message>
</context>
<context>
    <name>spacetow::FlightsPanel</name>
    <message>
        <source>No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or cave.NAME.replay.json in the same folder.</source>
        <translation>No hay ningún vuelo guardado junto a este nivel. Un vuelo de cave.json es un archivo cave.replay.json o cave.NAME.replay.json en la misma carpeta.</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Vuelos</translation>
    </message>
</context>
<context>
    <name>spacetow::Form</name>
    <message>
        <source>Fold or unfold this section</source>
        <translation>Plegar o desplegar esta sección</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Volver al valor inicial</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Volver al valor inicial: %1</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Stars</source>
        <translation>Estrellas</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Liso</translation>
    </message>
    <message>
        <source>%1 of the %2 selected objects have this.</source>
        <translation>%1 de los %2 objetos seleccionados tienen esto.</translation>
    </message>
</context>
<context>
    <name>spacetow::GuideBar</name>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>X of the guide</source>
        <translation>X de la guía</translation>
    </message>
    <message>
        <source>Y of the guide</source>
        <translation>Y de la guía</translation>
    </message>
    <message>
        <source>Angle of the guide</source>
        <translation>Ángulo de la guía</translation>
    </message>
    <message>
        <source>Name of the guide</source>
        <translation>Nombre de la guía</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>Eliminar esta guía</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryModel</name>
    <message numerus="yes">
        <source>%n older changes that can no longer be undone</source>
        <translation>
            <numerusform>%n cambio anterior que ya no se puede deshacer</numerusform>
            <numerusform>%n cambios anteriores que ya no se pueden deshacer</numerusform>
        </translation>
    </message>
    <message>
        <source>present state</source>
        <translation>estado actual</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>deshecho</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>guardado</translation>
    </message>
    <message>
        <source>Saved: the file holds this state</source>
        <translation>Guardado: el archivo contiene este estado</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historial</translation>
    </message>
    <message>
        <source>Click to go back, or forward again, to the state after an edit</source>
        <translation>Haga clic para volver atrás, o de nuevo adelante, al estado tras un cambio</translation>
    </message>
</context>
<context>
    <name>spacetow::ImportBar</name>
    <message>
        <source>Progress of the import</source>
        <translation>Progreso de la importación</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importar</translation>
    </message>
    <message>
        <source>Add what is shown to the level (Enter)</source>
        <translation>Añadir al nivel lo que se muestra (Intro)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Leave the level as it was (Escape)</source>
        <translation>Dejar el nivel como estaba (Esc)</translation>
    </message>
    <message>
        <source>What a unit of the file is: a pixel of a drawing, a pixel of a map.</source>
        <translation>Qué es una unidad del archivo: un píxel de un dibujo, un píxel de un mapa.</translation>
    </message>
    <message>
        <source>How far straight segments may stray from a curve.</source>
        <translation>Cuánto pueden apartarse de una curva los segmentos rectos.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Escala</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Two-way walls</source>
        <translation>Líneas de dos caras</translation>
    </message>
    <message>
        <source>One-way walls</source>
        <translation>Muros de una cara</translation>
    </message>
    <message>
        <source>What lines without a fill become</source>
        <translation>Qué pasan a ser las líneas sin relleno</translation>
    </message>
    <message>
        <source>Fills as polygons</source>
        <translation>Rellenos: polígonos</translation>
    </message>
    <message>
        <source>Fills as walls</source>
        <translation>Rellenos: muros</translation>
    </message>
    <message>
        <source>What filled shapes become</source>
        <translation>Qué pasan a ser las formas con relleno</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Nueva capa</translation>
    </message>
    <message>
        <source>Put all of it into a new layer, named like the file</source>
        <translation>Ponerlo todo en una capa nueva, con el nombre del archivo</translation>
    </message>
    <message>
        <source>Center in view</source>
        <translation>Centrar en la vista</translation>
    </message>
    <message>
        <source>Put it into the middle of the view, else where the file has it</source>
        <translation>Ponerlo en el centro de la vista; si no, donde lo tiene el archivo</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importar %1</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Leyendo…</translation>
    </message>
    <message>
        <source>%1 objects, %2 vertices, %3 × %4 m</source>
        <translation>%1 objetos, %2 vértices, %3 × %4 m</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
</context>
<context>
    <name>spacetow::Inspector</name>
    <message>
        <source>A group cannot be put into itself.</source>
        <translation>Un grupo no se puede poner dentro de sí mismo.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>Which shape the fields of shapes speak of</source>
        <translation>De qué forma tratan los campos de formas</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>No hay nada seleccionado.</translation>
    </message>
    <message numerus="yes">
        <source>All %n shapes</source>
        <translation>
            <numerusform>%n forma</numerusform>
            <numerusform>Las %n formas</numerusform>
        </translation>
    </message>
    <message>
        <source>Shape %1: %2</source>
        <translation>Forma %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n nodes selected</source>
        <translation>
            <numerusform>%1, %n nodo seleccionado</numerusform>
            <numerusform>%1, %n nodos seleccionados</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n objeto</numerusform>
            <numerusform>%n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Eso saldría del rango del campo, así que no ha cambiado nada.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the values would leave the range of the field, so nothing has changed.</source>
        <translation>
            <numerusform>%n de los valores saldría del rango del campo, así que no ha cambiado nada.</numerusform>
            <numerusform>%n de los valores saldrían del rango del campo, así que no ha cambiado nada.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::KeyEditor</name>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Atajos de teclado</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>Buscar una acción o una tecla</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Las mías</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Teclas como en</translation>
    </message>
    <message>
        <source>Take all keys from a program that you know</source>
        <translation>Tomar todas las teclas de un programa que ya conoce</translation>
    </message>
    <message>
        <source>Keys as &amp;in</source>
        <translation>Teclas como e&amp;n</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Acción</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importar…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportar…</translation>
    </message>
    <message>
        <source>Reset &amp;All</source>
        <translation>Restablecer &amp;todo</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>Take back the last change of keys</source>
        <translation>Deshacer el último cambio de teclas</translation>
    </message>
    <message>
        <source>&amp;Take It Over</source>
        <translation>&amp;Asignarla aquí</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Restablecer</translation>
    </message>
    <message>
        <source>Give this action the keys that it came with</source>
        <translation>Dar a esta acción las teclas que traía</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>%1 leads to “%2” (%3).</source>
        <translation>%1 lleva a «%2» (%3).</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now, and no longer to “%3”.</source>
        <translation>%1 lleva ahora a «%2», y ya no a «%3».</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now.</source>
        <translation>%1 lleva ahora a «%2».</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Teclas (*.json);;Todos los archivos (*)</translation>
    </message>
    <message>
        <source>Import Keys</source>
        <translation>Importar teclas</translation>
    </message>
    <message>
        <source>Export Keys</source>
        <translation>Exportar teclas</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>No se puede leer «%1»: %2.</translation>
    </message>
    <message>
        <source>“%1” is too large to be a file of keys.</source>
        <translation>«%1» es demasiado grande para ser un archivo de teclas.</translation>
    </message>
    <message>
        <source>Nothing was taken from “%1”.</source>
        <translation>No se tomó nada de «%1».</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now.</source>
        <translation>Ahora las teclas son las de «%1».</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now. Nothing is called %2 here.</source>
        <translation>Ahora las teclas son las de «%1». Aquí nada se llama %2.</translation>
    </message>
    <message>
        <source>Wrote all keys to “%1”.</source>
        <translation>Se guardaron todas las teclas en «%1».</translation>
    </message>
    <message>
        <source>“%1” cannot be written: %2.</source>
        <translation>No se puede escribir «%1»: %2.</translation>
    </message>
    <message>
        <source>This key cannot be changed, so that there is always a way out of the game.</source>
        <translation>Esta tecla no se puede cambiar, para que siempre haya una salida del juego.</translation>
    </message>
</context>
<context>
    <name>spacetow::KeyRecorder</name>
    <message>
        <source>Press a key</source>
        <translation>Pulse una tecla</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nueva tecla</translation>
    </message>
</context>
<context>
    <name>spacetow::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Teclas</translation>
    </message>
    <message>
        <source>Search: a word, or a key as it is written</source>
        <translation>Buscar: una palabra, o una tecla tal como se escribe</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>No key does anything of that name.</source>
        <translation>Ninguna tecla hace nada con ese nombre.</translation>
    </message>
</context>
<context>
    <name>spacetow::Legend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Leyenda de las superposiciones</translation>
    </message>
    <message>
        <source>Hide the legend</source>
        <translation>Ocultar la leyenda</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Desactivar</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Elegir otro color</translation>
    </message>
    <message>
        <source>What is too small at this zoom is not drawn</source>
        <translation>Lo que es demasiado pequeño con este zoom no se dibuja</translation>
    </message>
    <message>
        <source>Names that would lie on others are left out</source>
        <translation>Se omiten los nombres que taparían otros</translation>
    </message>
</context>
<context>
    <name>spacetow::LevelPanel</name>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Eso saldría del rango del campo, así que no ha cambiado nada.</translation>
    </message>
</context>
<context>
    <name>spacetow::MainWindow</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>There is nothing on the clipboard that can be pasted here.</source>
        <translation>En el portapapeles no hay nada que se pueda pegar aquí.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>Guardado %1</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>Leído de nuevo %1</translation>
    </message>
    <message>
        <source>About SpaceTow Studio</source>
        <translation>Acerca de SpaceTow Studio</translation>
    </message>
    <message>
        <source>SpaceTow Studio %1</source>
        <translation>SpaceTow Studio %1</translation>
    </message>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.

Free software under the MIT license. Made with Qt %1 and Eigen.</source>
        <translation>Dibujar niveles y volar en ellos: un editor de niveles y zona de pruebas de física.

Software libre bajo la licencia MIT. Hecho con Qt %1 y Eigen.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Cerrar</translation>
    </message>
    <message>
        <source>Was open at the end of the last run, but is gone: %1</source>
        <translation>Estaba abierto al final de la última sesión, pero ya no existe: %1</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <translation>viene con el programa</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message numerus="yes">
        <source>The level has %n errors and may not play as it should; see Problems.</source>
        <translation>
            <numerusform>El nivel tiene %n error y quizá no se juegue como debería; véase Problemas.</numerusform>
            <numerusform>El nivel tiene %n errores y quizá no se juegue como debería; véase Problemas.</numerusform>
        </translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>won</source>
        <translation>ganado</translation>
    </message>
    <message>
        <source>crashed</source>
        <translation>choque</translation>
    </message>
    <message>
        <source>game over</source>
        <translation>fin del juego</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>a punto</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>en juego</translation>
    </message>
    <message>
        <source>%1[*] (%2) - SpaceTow Studio</source>
        <translation>%1[*] (%2) - SpaceTow Studio</translation>
    </message>
    <message>
        <source>%1[*] - SpaceTow Studio</source>
        <translation>%1[*] - SpaceTow Studio</translation>
    </message>
    <message>
        <source>New level</source>
        <translation>Nuevo nivel</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>Abierto %1</translation>
    </message>
    <message>
        <source>No level is open · arrows, Tab and Enter choose one</source>
        <translation>No hay ningún nivel abierto · flechas, Tab e Intro eligen uno</translation>
    </message>
    <message>
        <source>snaps to: %1</source>
        <translation>se ajusta a: %1</translation>
    </message>
    <message>
        <source>Nothing was left unsaved.</source>
        <translation>No quedó nada sin guardar.</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Principal</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Herramientas</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aún no hay archivos</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Vaciar lista</translation>
    </message>
    <message>
        <source>Take back the level as it was saved then, as one edit; its file stays as it is</source>
        <translation>Volver al nivel tal como se guardó entonces, como un solo cambio; su archivo queda como está</translation>
    </message>
    <message>
        <source>No former versions yet</source>
        <translation>Aún no hay versiones anteriores</translation>
    </message>
    <message>
        <source>Select &amp;Under Pointer</source>
        <translation>Seleccionar ba&amp;jo el puntero</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Abrir &amp;recientes</translation>
    </message>
    <message>
        <source>&amp;Backups</source>
        <translation>Copias &amp;de seguridad</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>O&amp;verlays</source>
        <translation>S&amp;uperposiciones</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>Ajus&amp;te</translation>
    </message>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>&amp;Paso de cuadrícula</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>Su&amp;bcuadrícula</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>Pane&amp;les</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>Apar&amp;iencia</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Insertar</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objeto</translation>
    </message>
    <message>
        <source>&amp;Order</source>
        <translation>O&amp;rden</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Alin&amp;ear</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>Tran&amp;sformar</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>Tra&amp;yecto</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Nivel</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Jugar</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Ven&amp;tana</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Ay&amp;uda</translation>
    </message>
    <message>
        <source>Should the program end all of a sudden, what is not saved will be lost:</source>
        <translation>Si el programa termina de repente, se perderá lo que no está guardado:</translation>
    </message>
    <message>
        <source>%1 is open in another window too. What is saved there will arrive here.</source>
        <translation>%1 también está abierto en otra ventana. Lo que se guarde allí llegará aquí.</translation>
    </message>
    <message>
        <source>Texts in this language from now on, in all windows</source>
        <translation>Textos en este idioma desde ahora, en todas las ventanas</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Como el &amp;escritorio</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Idio&amp;ma</translation>
    </message>
    <message>
        <source>The game was ended: so many bodies lie in the same place that the computer&apos;s memory would not hold what happens between them. Move them apart, and play again.</source>
        <translation>El juego se ha terminado: hay tantos cuerpos en el mismo lugar que la memoria del equipo no alcanzaría para lo que ocurre entre ellos. Sepárelos y juegue de nuevo.</translation>
    </message>
    <message>
        <source>The game was ended: there is not enough memory for this level. Nothing of the level is lost.</source>
        <translation>El juego se ha terminado: no hay memoria suficiente para este nivel. No se ha perdido nada del nivel.</translation>
    </message>
    <message>
        <source>what was not saved of %1</source>
        <translation>lo que no se había guardado de %1</translation>
    </message>
    <message>
        <source>Write plots</source>
        <translation>Guardar curvas</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>Save flight</source>
        <translation>Guardar vuelo</translation>
    </message>
    <message>
        <source>Flights (*.replay.json)</source>
        <translation>Vuelos (*.replay.json)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>The plots are in “%1”.</source>
        <translation>Las curvas están en «%1».</translation>
    </message>
    <message>
        <source>Pulling · move: pull further · let the button go: throw</source>
        <translation>Tirando · mover: tirar más · soltar el botón: lanzar</translation>
    </message>
    <message>
        <source>Playing a recorded flight · who steers takes over · %1: back to the editor</source>
        <translation>Se reproduce un vuelo grabado · quien pilota toma el mando · %1: volver al editor</translation>
    </message>
    <message>
        <source>%1: follow the ship again</source>
        <translation>%1: seguir otra vez a la nave</translation>
    </message>
    <message>
        <source>Playing · drag a body: pull it · wheel, right drag: move the view · %1 held: back in time · %2: back to the editor · Esc: menu</source>
        <translation>Jugando · arrastrar un cuerpo: tirar de él · rueda, arrastrar con el botón derecho: mover la vista · mantener %1: retroceder en el tiempo · %2: volver al editor · Esc: menú</translation>
    </message>
    <message>
        <source>Simulation held · click: select · drag: move · %1: go on from here · %2: next frame · %3: back to the editor</source>
        <translation>Simulación en pausa · clic: seleccionar · arrastrar: mover · %1: seguir desde aquí · %2: fotograma siguiente · %3: volver al editor</translation>
    </message>
    <message>
        <source>Simulation running · click: select · drag: pull a body, move what stands still · %1: hold · %2: back to the editor</source>
        <translation>Simulación en marcha · clic: seleccionar · arrastrar: tirar de un cuerpo, mover lo que está quieto · %1: pausar · %2: volver al editor</translation>
    </message>
    <message>
        <source>Here begins a new level.
%1: draw the walls of a cave, anticlockwise
%2: place ship, payload and finish
%3: play
%4, %5: draw boxes and balls
%6: simulate
%7: find everything else</source>
        <translation>Aquí empieza un nuevo nivel.
%1: dibujar las paredes de una cueva, en sentido antihorario
%2: colocar nave, carga y meta
%3: jugar
%4, %5: dibujar cajas y bolas
%6: simular
%7: encontrar todo lo demás</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>simulando</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simular</translation>
    </message>
    <message>
        <source>Held within an update, after iteration %1 of %2 · %3: next iteration · %4: go on from here</source>
        <translation>Detenido dentro de una actualización, tras la iteración %1 de %2 · %3: siguiente iteración · %4: seguir desde aquí</translation>
    </message>
    <message>
        <source>Held · %1: go on from here · %2: next frame · %3: previous frame · %4: back to the editor</source>
        <translation>Detenido · %1: seguir desde aquí · %2: fotograma siguiente · %3: fotograma anterior · %4: volver al editor</translation>
    </message>
    <message>
        <source> · it will move; walls and lines stand still</source>
        <translation> · se moverá; paredes y líneas quedan quietas</translation>
    </message>
    <message>
        <source>Getting ready to run: %1 s so far · %2: leave it</source>
        <translation>Preparando la ejecución: %1 s hasta ahora · %2: dejarlo</translation>
    </message>
    <message>
        <source>Too much for this computer: %1 s behind real time · %2: back to the editor</source>
        <translation>Demasiado para este equipo: %1 s de retraso respecto al tiempo real · %2: volver al editor</translation>
    </message>
    <message>
        <source>Simulating the run: %1 of %2 s so far · %3: leave it</source>
        <translation>Simulando la ejecución: %1 de %2 s hasta ahora · %3: dejarlo</translation>
    </message>
    <message>
        <source>Playing a recorded simulation · %1: back to the editor</source>
        <translation>Se reproduce una simulación grabada · %1: volver al editor</translation>
    </message>
    <message>
        <source>A connector is pasted together with the two bodies that it joins.</source>
        <translation>Un conector se pega junto con los dos cuerpos que une.</translation>
    </message>
    <message>
        <source>A level has one ship, one payload and one finish, and this one has them already.</source>
        <translation>Un nivel tiene una nave, una carga y una meta, y este ya las tiene.</translation>
    </message>
    <message>
        <source>Nothing that is selected has an edge at the pointer.</source>
        <translation>Nada de lo seleccionado tiene un borde en el puntero.</translation>
    </message>
    <message>
        <source>Edit N&amp;odes</source>
        <translation>Editar n&amp;odos</translation>
    </message>
    <message>
        <source>%1: unlock all</source>
        <translation>%1: desbloquear todo</translation>
    </message>
    <message>
        <source>Reading %1: %2 s so far · %3: leave it</source>
        <translation>Leyendo %1: %2 s hasta ahora · %3: abandonar</translation>
    </message>
</context>
<context>
    <name>spacetow::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Cerrar este mensaje</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
</context>
<context>
    <name>spacetow::Minimap</name>
    <message>
        <source>Minimap</source>
        <translation>Minimapa</translation>
    </message>
    <message>
        <source>Click or drag: go there · wheel: zoom · arrows: move the view</source>
        <translation>Clic o arrastrar: ir ahí · rueda: zoom · flechas: mover la vista</translation>
    </message>
</context>
<context>
    <name>spacetow::MotionLine</name>
    <message>
        <source>Now, while it runs</source>
        <translation>Ahora, en marcha</translation>
    </message>
    <message>
        <source>How the body moves now, while it runs; the fields say where it starts</source>
        <translation>Cómo se mueve ahora el cuerpo, en marcha; los campos dicen dónde empieza</translation>
    </message>
    <message>
        <source>Now: x %1 · y %2 m · %3°</source>
        <translation>Ahora: x %1 · y %2 m · %3°</translation>
    </message>
    <message>
        <source>%1 m/s (x %2 · y %3) · %4°/s</source>
        <translation>%1 m/s (x %2 · y %3) · %4°/s</translation>
    </message>
    <message>
        <source>Now: %1 m long, %2 m at rest</source>
        <translation>Ahora: %1 m de largo, %2 m en reposo</translation>
    </message>
    <message>
        <source>pushes with %1 N</source>
        <translation>empuja con %1 N</translation>
    </message>
    <message>
        <source>pulls with %1 N</source>
        <translation>tira con %1 N</translation>
    </message>
    <message>
        <source>Now: not there any more</source>
        <translation>Ahora: ya no está</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesDelegate</name>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Eso saldría del mapa, que termina a %1 m del origen.</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesModel</name>
    <message>
        <source>shape %1: %2</source>
        <translation>forma %1: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Nodo</translation>
    </message>
    <message>
        <source>x [m]</source>
        <translation>x [m]</translation>
    </message>
    <message>
        <source>y [m]</source>
        <translation>y [m]</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesPanel</name>
    <message>
        <source>Nodes of the objects in edit</source>
        <translation>Nodos de los objetos que se editan</translation>
    </message>
    <message>
        <source>Double click or type to change a coordinate; with several rows selected, in all of them</source>
        <translation>Haga doble clic o escriba para cambiar una coordenada; con varias filas seleccionadas, en todas</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insertar</translation>
    </message>
    <message>
        <source>Insert a node halfway to the next one</source>
        <translation>Insertar un nodo a medio camino del siguiente</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete the selected nodes</source>
        <translation>Eliminar los nodos seleccionados</translation>
    </message>
</context>
<context>
    <name>spacetow::NumberField</name>
    <message>
        <source>Type a number or an expression such as 2*pi/3, 20 cm, +=0.5 or *=2 · Up, Down, wheel: step · Shift: finer · Ctrl: coarser</source>
        <translation>Escriba un número o una expresión como 2*pi/3, 20 cm, +=0.5 o *=2 · flechas arriba y abajo, rueda: paso · Mayús: más fino · Ctrl: más grueso</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>Exactly %1 %2</source>
        <translation>Exactamente %1 %2</translation>
    </message>
    <message>
        <source>A whole number</source>
        <translation>Un número entero</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>Un número</translation>
    </message>
    <message>
        <source>%1 above %2 and up to %3</source>
        <translation>%1 mayor que %2 y hasta %3</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 a %3</translation>
    </message>
    <message>
        <source>%1 above %2</source>
        <translation>%1 mayor que %2</translation>
    </message>
    <message>
        <source>%1 of %2 or more</source>
        <translation>%1 desde %2</translation>
    </message>
    <message>
        <source>%1, or nothing</source>
        <translation>%1, o nada</translation>
    </message>
    <message>
        <source>The result is too large.</source>
        <translation>El resultado es demasiado grande.</translation>
    </message>
    <message>
        <source>%1 is not possible: %2.</source>
        <translation>%1 no es posible: %2.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«%1» no es un número.</translation>
    </message>
</context>
<context>
    <name>spacetow::ObjectField</name>
    <message>
        <source>There is no object with this key.</source>
        <translation>No hay ningún objeto con esta clave.</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>varios</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”; write the name or the key of another object.</source>
        <translation>Aquí nada se llama «%1»; escriba el nombre o la clave de otro objeto.</translation>
    </message>
    <message>
        <source>Several objects are called “%1”; write the key of the one you mean.</source>
        <translation>Varios objetos se llaman «%1»; escriba la clave del que busca.</translation>
    </message>
    <message>
        <source>Choose from a list (Down)</source>
        <translation>Elegir de una lista (Abajo)</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translation>%1, clave %2</translation>
    </message>
    <message>
        <source>Select it and bring it into the middle of the view</source>
        <translation>Seleccionarlo y llevarlo al centro de la vista</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Color of the group. Click to choose another one</source>
        <translation>Color del grupo. Haga clic para elegir otro</translation>
    </message>
    <message>
        <source>Hidden in the editor; played all the same. Click to show it</source>
        <translation>Oculto en el editor; en el juego sigue estando. Haga clic para mostrarlo</translation>
    </message>
    <message>
        <source>Visible. Click to hide it in the editor</source>
        <translation>Visible. Haga clic para ocultarlo en el editor</translation>
    </message>
    <message>
        <source>Locked: not picked on the canvas, moved or deleted. Click to unlock it</source>
        <translation>Bloqueado: no se toma en el lienzo, ni se mueve ni se elimina. Haga clic para desbloquearlo</translation>
    </message>
    <message>
        <source>Not locked. Click to lock it against changes</source>
        <translation>No bloqueado. Haga clic para bloquearlo contra cambios</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>oculto</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>bloqueado</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>no bloqueado</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Color</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Bloqueado</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerPanel</name>
    <message>
        <source>What is locked stays where it is; unlock it to move it.</source>
        <translation>Lo bloqueado se queda donde está; desbloquéelo para moverlo.</translation>
    </message>
    <message>
        <source>Find: name, kind:wall, tag:ice</source>
        <translation>Buscar: nombre, kind:wall, tag:ice</translation>
    </message>
    <message>
        <source>Filter of the objects</source>
        <translation>Filtro de los objetos</translation>
    </message>
    <message>
        <source>Choose what to find</source>
        <translation>Elegir qué buscar</translation>
    </message>
    <message>
        <source>Color of the Group</source>
        <translation>Color del grupo</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Tipo</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Etiqueta</translation>
    </message>
    <message>
        <source>Shows the objects whose name holds these words, with their groups.
kind:wall, tag:ice, is:hidden and is:locked ask for other things; a minus before a word turns it round. Enter selects all that is found.
The list shows what is drawn on top first.</source>
        <translation>Muestra los objetos cuyo nombre contiene estas palabras, con sus grupos.
kind:wall, tag:ice, is:hidden e is:locked preguntan por otras cosas; un menos delante de una palabra la invierte. Intro selecciona todo lo encontrado.
La lista muestra primero lo que se dibuja encima.</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerView</name>
    <message>
        <source>Objects of the level</source>
        <translation>Objetos del nivel</translation>
    </message>
    <message>
        <source>No object matches the filter.</source>
        <translation>Ningún objeto coincide con el filtro.</translation>
    </message>
    <message>
        <source>The level has no objects.</source>
        <translation>El nivel no tiene objetos.</translation>
    </message>
</context>
<context>
    <name>spacetow::OverlayColorsDialog</name>
    <message>
        <source>&amp;Set of colors:</source>
        <translation>&amp;Juego de colores:</translation>
    </message>
    <message>
        <source>&amp;Forget Own Colors</source>
        <translation>Olvidar colores p&amp;ropios</translation>
    </message>
    <message>
        <source>Colors of the overlays</source>
        <translation>Colores de las superposiciones</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Estándar</translation>
    </message>
    <message>
        <source>Okabe and Ito, safe with any color vision</source>
        <translation>Okabe e Ito, segura con cualquier visión del color</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Elegir otro color</translation>
    </message>
    <message>
        <source>The color of the set again</source>
        <translation>De nuevo el color del juego</translation>
    </message>
    <message>
        <source>%1: the color of the set again</source>
        <translation>%1: de nuevo el color del juego</translation>
    </message>
</context>
<context>
    <name>spacetow::PauseMenu</name>
    <message>
        <source>You made it!</source>
        <translation>¡Conseguido!</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Choque</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Fin del juego</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pausa</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Continuar</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Back to the editor</source>
        <translation>Volver al editor</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>Dejar de jugar</translation>
    </message>
    <message>
        <source>Go on playing</source>
        <translation>Seguir jugando</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Empezar el nivel de nuevo</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotPanel</name>
    <message>
        <source>Quantity of the selection</source>
        <translation>Magnitud de la selección</translation>
    </message>
    <message>
        <source>What of the selected body or connector, or of everything, is to be plotted</source>
        <translation>Qué se va a trazar del cuerpo o conector seleccionado, o del conjunto</translation>
    </message>
    <message>
        <source>Add curve</source>
        <translation>Añadir curva</translation>
    </message>
    <message>
        <source>x against y</source>
        <translation>x frente a y</translation>
    </message>
    <message>
        <source>The second curve against the first, in place of all over time</source>
        <translation>La segunda curva frente a la primera, en vez de todas frente al tiempo</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Write what is plotted into a file that spreadsheets read</source>
        <translation>Guardar lo trazado en un archivo que leen las hojas de cálculo</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vaciar</translation>
    </message>
    <message>
        <source>Remove all curves</source>
        <translation>Eliminar todas las curvas</translation>
    </message>
    <message>
        <source>Drift: how far energy has come from its first value, as a share of the most that was ever in motion or in springs; and momentum, as a share of the most that all bodies had</source>
        <translation>Deriva: cuánto se ha alejado la energía de su primer valor, como parte de lo máximo que hubo en movimiento o en los muelles; y el momento lineal, como parte de lo máximo que tuvieron todos los cuerpos</translation>
    </message>
    <message>
        <source>Select a body or a connector, choose a quantity and add its curve. It grows while the level is played or simulated.</source>
        <translation>Seleccione un cuerpo o un conector, elija una magnitud y añada su curva. Crece mientras el nivel se juega o se simula.</translation>
    </message>
    <message>
        <source>Remove the curve “%1”</source>
        <translation>Eliminar la curva «%1»</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>No hay nada en marcha.</translation>
    </message>
    <message>
        <source>Energy %1 J, %2 J since the start (drift %3) · momentum %4 kg m/s (drift %5)</source>
        <translation>Energía %1 J, %2 J desde el inicio (deriva %3) · momento lineal %4 kg m/s (deriva %5)</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotView</name>
    <message>
        <source>Plot</source>
        <translation>Curvas</translation>
    </message>
    <message>
        <source>Wheel: zoom · drag: move · double-click: show everything</source>
        <translation>Rueda: zoom · arrastrar: mover · doble clic: mostrar todo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemDelegate</name>
    <message>
        <source>Fix</source>
        <translation>Corregir</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemList</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemsPanel</name>
    <message>
        <source>Show notes: what could be tidied</source>
        <translation>Mostrar notas: lo que se podría ordenar</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Mostrar advertencias</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Mostrar errores</translation>
    </message>
    <message>
        <source>Show the problems that are hidden in this level, too</source>
        <translation>Mostrar también los problemas ocultos en este nivel</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Remediar todos los problemas cuya corrección no cambia nada intencionado</translation>
    </message>
    <message>
        <source>Problems of the level</source>
        <translation>Problemas del nivel</translation>
    </message>
    <message>
        <source>Hidden: %1</source>
        <translation>Ocultos: %1</translation>
    </message>
    <message>
        <source>Fix all that is safe: %1</source>
        <translation>Corregir lo seguro: %1</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Comprobando…</translation>
    </message>
    <message>
        <source>Nothing to complain about.</source>
        <translation>Nada que objetar.</translation>
    </message>
    <message>
        <source>Nothing else: the rest is filtered out or hidden.</source>
        <translation>Nada más: el resto está filtrado u oculto.</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>Corregir: %1</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Volver a mostrarlo</translation>
    </message>
    <message>
        <source>Hide it in this level</source>
        <translation>Ocultarlo en este nivel</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Copiar texto</translation>
    </message>
    <message>
        <source>Nothing was found that would cure this by itself.</source>
        <translation>No se ha encontrado nada que corrija esto por sí solo.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfileChart</name>
    <message>
        <source>Times of the last updates</source>
        <translation>Tiempos de las últimas actualizaciones</translation>
    </message>
    <message>
        <source>The last updates, newest at the right; the colors are those of the stages below</source>
        <translation>Las últimas actualizaciones, la más nueva a la derecha; los colores son los de las etapas de abajo</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Times are taken while the level is played or simulated.</source>
        <translation>Los tiempos se miden mientras el nivel se juega o se simula.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfilePanel</name>
    <message>
        <source>Stage, ms</source>
        <translation>Etapa, ms</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Ahora</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Media</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Máximo</translation>
    </message>
    <message>
        <source>Times and counters</source>
        <translation>Tiempos y contadores</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryBar</name>
    <message>
        <source>The program ended with work that was not saved:</source>
        <translation>El programa terminó con trabajo sin guardar:</translation>
    </message>
    <message>
        <source>Not now: it is kept, and offered again</source>
        <translation>Ahora no: se conserva y se ofrece de nuevo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Beside the file as it is now:</source>
        <translation>Junto al archivo como es ahora:</translation>
    </message>
    <message>
        <source>There is no file to compare it with:</source>
        <translation>No hay archivo con el que compararlo:</translation>
    </message>
    <message>
        <source>It is the same as the file.</source>
        <translation>Es igual que el archivo.</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryRow</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n objeto</numerusform>
            <numerusform>%n objetos</numerusform>
        </translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nunca guardado</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurar</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparar</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Descartar</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Go on with this level; its file stays as it is until you save</source>
        <translation>Seguir con este nivel; su archivo queda como está hasta que usted guarde</translation>
    </message>
    <message>
        <source>Do not offer this any more</source>
        <translation>No ofrecer esto más</translation>
    </message>
    <message>
        <source>Discarded.</source>
        <translation>Descartado.</translation>
    </message>
    <message>
        <source>Say and show what differs from the file</source>
        <translation>Decir y mostrar en qué difiere del archivo</translation>
    </message>
</context>
<context>
    <name>spacetow::Ruler</name>
    <message>
        <source>Ruler above the drawing board</source>
        <translation>Regla sobre el lienzo</translation>
    </message>
    <message>
        <source>Ruler beside the drawing board</source>
        <translation>Regla junto al lienzo</translation>
    </message>
    <message>
        <source>Metres; drag a horizontal guide out of the ruler</source>
        <translation>Metros; arrastre una guía horizontal desde la regla</translation>
    </message>
    <message>
        <source>Metres; drag a vertical guide out of the ruler</source>
        <translation>Metros; arrastre una guía vertical desde la regla</translation>
    </message>
</context>
<context>
    <name>spacetow::RulerCorner</name>
    <message>
        <source>Corner of the rulers</source>
        <translation>Esquina de las reglas</translation>
    </message>
    <message>
        <source>Metres; drag a slanting guide out of the corner</source>
        <translation>Metros; arrastre una guía inclinada desde la esquina</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesList</name>
    <message>
        <source>Is kept only together with:
%1</source>
        <translation>Solo se conserva junto con:
%1</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesPanel</name>
    <message>
        <source>Keep &amp;All</source>
        <translation>Conservar &amp;todo</translation>
    </message>
    <message>
        <source>Keep &amp;Ticked</source>
        <translation>Conservar &amp;marcados</translation>
    </message>
    <message>
        <source>&amp;Discard All</source>
        <translation>&amp;Descartar todo</translation>
    </message>
    <message>
        <source>Changes made in this run</source>
        <translation>Cambios hechos en esta ejecución</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, each as one step that can be undone</source>
        <translation>Hace todos estos cambios en el nivel, cada uno como un paso que se puede deshacer</translation>
    </message>
    <message>
        <source>Makes those that are ticked in the level, and forgets the others</source>
        <translation>Hace en el nivel los que están marcados y olvida los demás</translation>
    </message>
    <message>
        <source>Leaves the level as it was before the run; Undo brings the changes back</source>
        <translation>Deja el nivel como estaba antes de la ejecución; Deshacer recupera los cambios</translation>
    </message>
    <message numerus="yes">
        <source>%n changes were made in this run. The level is as before; keep what you like.</source>
        <translation>
            <numerusform>Se hizo %n cambio en esta ejecución. El nivel está como antes; consérvelo si quiere.</numerusform>
            <numerusform>Se hicieron %n cambios en esta ejecución. El nivel está como antes; conserve lo que quiera.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing waits to be kept. What is changed in a level while it runs is listed here when the run ends.</source>
        <translation>No hay nada pendiente de conservar. Lo que se cambia en un nivel en marcha aparece aquí al terminar la ejecución.</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, as one step that can be undone</source>
        <translation>Hace todos estos cambios en el nivel, como un paso que se puede deshacer</translation>
    </message>
    <message>
        <source>The end of the run is undone: what was changed in it is in the level again. Redo takes it out, and lists it to be kept.</source>
        <translation>Se ha deshecho el final de la ejecución: lo que se cambió está de nuevo en el nivel. Rehacer lo quita y lo lista para conservarlo.</translation>
    </message>
</context>
<context>
    <name>spacetow::ScrubLabel</name>
    <message>
        <source>Drag: change the number · Shift: a tenth as fast · Ctrl: in whole steps · Escape: take it back</source>
        <translation>Arrastrar: cambiar el número · Mayús: diez veces más lento · Ctrl: en pasos enteros · Esc: volver atrás</translation>
    </message>
</context>
<context>
    <name>spacetow::StatusLine</name>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>&amp;Paso de cuadrícula</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>Su&amp;bcuadrícula</translation>
    </message>
    <message>
        <source>How points snap; Shift+G switches the grid, Shift+S the rest, Ctrl suspends both</source>
        <translation>Cómo se ajustan los puntos; Mayús+G cambia la cuadrícula, Mayús+S el resto, Ctrl suspende ambos</translation>
    </message>
    <message>
        <source>Next problem (F4)</source>
        <translation>Problema siguiente (F4)</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Ninguna</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 partes</translation>
    </message>
    <message>
        <source>x %1  y %2 m</source>
        <translation>x %1  y %2 m</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n seleccionado</numerusform>
            <numerusform>%n seleccionados</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 × %2 m</source>
        <translation>, %1 × %2 m</translation>
    </message>
    <message>
        <source>Snap %1 m</source>
        <translation>Ajuste %1 m</translation>
    </message>
    <message>
        <source>Snap to objects</source>
        <translation>Ajuste a objetos</translation>
    </message>
    <message>
        <source>Snap off</source>
        <translation>Sin ajuste</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errores</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n advertencia</numerusform>
            <numerusform>%n advertencias</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Sin problemas</translation>
    </message>
</context>
<context>
    <name>spacetow::TagGrid</name>
    <message>
        <source>everything</source>
        <translation>todo</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>Nueva etiqueta</translation>
    </message>
    <message>
        <source>Name another of the 32 tags</source>
        <translation>Dar nombre a otra de las 32 etiquetas</translation>
    </message>
    <message>
        <source>%1 – double-click or F2 to rename, right-click for more</source>
        <translation>%1 – doble clic o F2 para renombrar, clic derecho para más</translation>
    </message>
    <message>
        <source>everything except</source>
        <translation>todo excepto</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later, but for those crossed out; click for everything</source>
        <translation>Toca todo lo que tiene una etiqueta, también las que se creen después, salvo las tachadas; clic: todo</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later; click for nothing, click a tag to leave it out</source>
        <translation>Toca todo lo que tiene una etiqueta, también las que se creen después; clic: nada, clic en una etiqueta: dejarla fuera</translation>
    </message>
    <message>
        <source>Touches the marked tags only; click for everything</source>
        <translation>Toca solo las etiquetas marcadas; clic: todo</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renombrar</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Color…</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Seleccionar todo con esta etiqueta</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Color de «%1»</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixPanel</name>
    <message>
        <source>Name of the tag</source>
        <translation>Nombre de la etiqueta</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Seleccionar todo con esta etiqueta</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renombrar</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Color…</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Color de «%1»</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixView</name>
    <message>
        <source>Tag matrix</source>
        <translation>Matriz de etiquetas</translation>
    </message>
    <message>
        <source>No object is “%1” or “%2”.</source>
        <translation>Ningún objeto es «%1» ni «%2».</translation>
    </message>
    <message>
        <source>“%1” and “%2” pass through each other.</source>
        <translation>«%1» y «%2» se atraviesan.</translation>
    </message>
    <message>
        <source>“%1” and “%2” touch each other.</source>
        <translation>«%1» y «%2» se tocan.</translation>
    </message>
    <message>
        <source>Some that are “%1” and “%2” touch each other.</source>
        <translation>Algunos que son «%1» y «%2» se tocan.</translation>
    </message>
    <message>
        <source>The rules of the game say so.</source>
        <translation>Así lo dicen las reglas del juego.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are “%1”; double-click to select them, right-click for more</source>
        <translation>
            <numerusform>%n objeto es «%1»; doble clic para seleccionarlo, clic derecho para más</numerusform>
            <numerusform>%n objetos son «%1»; doble clic para seleccionarlos, clic derecho para más</numerusform>
        </translation>
    </message>
    <message>
        <source>They did touch in the last run.</source>
        <translation>Se tocaron en la última ejecución.</translation>
    </message>
    <message>
        <source>They met in the last run, and passed through each other.</source>
        <translation>Se encontraron en la última ejecución y se atravesaron.</translation>
    </message>
</context>
<context>
    <name>spacetow::TimelineBar</name>
    <message>
        <source>%1 / %2 s</source>
        <translation>%1 / %2 s</translation>
    </message>
    <message>
        <source>1/%1 ×</source>
        <translation>1/%1 ×</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>How fast time runs</source>
        <translation>Con qué rapidez pasa el tiempo</translation>
    </message>
</context>
<context>
    <name>spacetow::TimelineScale</name>
    <message>
        <source>Touch</source>
        <translation>Contacto</translation>
    </message>
    <message>
        <source>Payload taken in tow</source>
        <translation>Carga tomada a remolque</translation>
    </message>
    <message>
        <source>Payload let go</source>
        <translation>Carga soltada</translation>
    </message>
    <message>
        <source>Crash</source>
        <translation>Choque</translation>
    </message>
    <message>
        <source>New attempt</source>
        <translation>Nuevo intento</translation>
    </message>
    <message>
        <source>Win</source>
        <translation>Victoria</translation>
    </message>
    <message>
        <source>Edit of the level</source>
        <translation>Cambio del nivel</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, en %2</translation>
    </message>
    <message>
        <source>The selected body touches something</source>
        <translation>El cuerpo seleccionado toca algo</translation>
    </message>
    <message>
        <source>The selected body parts from something</source>
        <translation>El cuerpo seleccionado se separa de algo</translation>
    </message>
    <message>
        <source>Dashed on the canvas: what was to come before the run was changed. Without a ship these are the ways of the selected body and of up to %1 others.</source>
        <translation>Con trazos en el lienzo: lo que iba a venir antes de que se cambiara la ejecución. Sin nave, son los caminos del cuerpo seleccionado y de hasta %1 más.</translation>
    </message>
</context>
<context>
    <name>spacetow::TransformBar</name>
    <message>
        <source>Transform</source>
        <translation>Transformar</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Altura</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Girar</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativo</translation>
    </message>
    <message>
        <source>Move by metres and scale by percent instead of to a place and size</source>
        <translation>Mover en metros y escalar en porcentaje, en vez de a una posición y un tamaño</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this bar (Escape)</source>
        <translation>Cerrar esta barra (Esc)</translation>
    </message>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Eso saldría del mapa, que termina a %1 m del origen.</translation>
    </message>
</context>
<context>
    <name>spacetow::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>Bienvenida</translation>
    </message>
    <message>
        <source>Draw a cave, and fly your load out of it.</source>
        <translation>Dibuje una cueva y saque de ella su carga volando.</translation>
    </message>
    <message>
        <source>&amp;New Level</source>
        <translation>&amp;Nuevo nivel</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Abrir…</translation>
    </message>
    <message>
        <source>Recent levels</source>
        <translation>Niveles recientes</translation>
    </message>
    <message>
        <source>Levels that come with the program; what you open is a copy</source>
        <translation>Niveles que vienen con el programa; lo que se abre es una copia</translation>
    </message>
    <message>
        <source>&amp;Show this page at start and when the last level is closed</source>
        <translation>&amp;Mostrar esta página al inicio y al cerrar el último nivel</translation>
    </message>
    <message>
        <source>Sandbox</source>
        <translation>Zona de pruebas</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Nivel</translation>
    </message>
    <message>
        <source>Sandboxes: each shows one thing that the physics does, and says what to try</source>
        <translation>Zonas de pruebas: cada una muestra algo que hace la física y dice qué probar</translation>
    </message>
</context>
<context>
    <name>spacetow::ZoomField</name>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Zoom: type a percentage, or choose one; Ctrl+0 shows the original size</source>
        <translation>Zoom: escriba un porcentaje o elija uno; Ctrl+0 muestra el tamaño original</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
</TS>
