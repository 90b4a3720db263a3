<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Neu</translation>
    </message>
    <message>
        <source>Start an empty level</source>
        <translation>Ein leeres Level beginnen</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open a level file</source>
        <translation>Eine Leveldatei öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Write the level to its file</source>
        <translation>Das Level in seine Datei schreiben</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>Write the level to another file</source>
        <translation>Das Level in eine andere Datei schreiben</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Die letzte Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Die zurückgenommene Änderung erneut ausführen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>Move the selection to the clipboard</source>
        <translation>Die Auswahl in die Zwischenablage verschieben</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>Copy the selection to the clipboard as text</source>
        <translation>Die Auswahl als Text in die Zwischenablage kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard at the pointer</source>
        <translation>Den Inhalt der Zwischenablage am Mauszeiger einfügen</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>An &amp;Originalposition einfügen</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard where it was copied</source>
        <translation>Den Inhalt der Zwischenablage dort einfügen, wo er kopiert wurde</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>Copy the selection one grid step away</source>
        <translation>Die Auswahl um einen Rasterschritt versetzt kopieren</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>Die Auswahl entfernen</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>Alles au&amp;swählen</translation>
    </message>
    <message>
        <source>Select every object</source>
        <translation>Alle Objekte auswählen</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>&amp;Nichts auswählen</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Die Auswahl aufheben</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>A&amp;uswahl umkehren</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Auswählen, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>V&amp;ergrößern</translation>
    </message>
    <message>
        <source>Show less of the level, larger</source>
        <translation>Weniger vom Level zeigen, dafür größer</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Show more of the level, smaller</source>
        <translation>Mehr vom Level zeigen, dafür kleiner</translation>
    </message>
    <message>
        <source>Show the level as large as in the game</source>
        <translation>Das Level so groß zeigen wie im Spiel</translation>
    </message>
    <message>
        <source>&amp;Fit Level</source>
        <translation>Level ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole level</source>
        <translation>Das ganze Level zeigen</translation>
    </message>
    <message>
        <source>&amp;Center Selection</source>
        <translation>Auswahl &amp;zentrieren</translation>
    </message>
    <message>
        <source>Bring the selection to the middle of the view</source>
        <translation>Die Auswahl in die Mitte der Ansicht holen</translation>
    </message>
    <message>
        <source>Show the selection as large as fits</source>
        <translation>Die Auswahl so groß wie möglich zeigen</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>&amp;Raster</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Das Raster anzeigen</translation>
    </message>
    <message>
        <source>&amp;Snap to Grid</source>
        <translation>Am Raster ei&amp;nrasten</translation>
    </message>
    <message>
        <source>&amp;Bounding Boxes</source>
        <translation>&amp;Hüllrechtecke</translation>
    </message>
    <message>
        <source>&amp;Incircles</source>
        <translation>&amp;Inkreise</translation>
    </message>
    <message>
        <source>Show the incircle of every polygon</source>
        <translation>Den Inkreis jedes Polygons anzeigen</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>G&amp;eschwindigkeiten</translation>
    </message>
    <message>
        <source>Show where every body would be in a second</source>
        <translation>Anzeigen, wo jeder Körper in einer Sekunde wäre</translation>
    </message>
    <message>
        <source>&amp;Orientations</source>
        <translation>&amp;Ausrichtungen</translation>
    </message>
    <message>
        <source>Show which way up every body is</source>
        <translation>Anzeigen, wo bei jedem Körper oben ist</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>&amp;Normalen</translation>
    </message>
    <message>
        <source>&amp;All Off</source>
        <translation>Alle a&amp;us</translation>
    </message>
    <message>
        <source>Hide all overlays</source>
        <translation>Alle Einblendungen ausblenden</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Den ganzen Bildschirm nutzen</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>Aus&amp;wählen</translation>
    </message>
    <message>
        <source>Select and move objects</source>
        <translation>Objekte auswählen und verschieben</translation>
    </message>
    <message>
        <source>One-Way &amp;Wall</source>
        <translation>Einseitige &amp;Kante</translation>
    </message>
    <message>
        <source>Draw walls that are solid from one side</source>
        <translation>Wände zeichnen, die von einer Seite undurchdringlich sind</translation>
    </message>
    <message>
        <source>Two-Way &amp;Line</source>
        <translation>Zweiseitige &amp;Linie</translation>
    </message>
    <message>
        <source>Draw walls that are solid from both sides</source>
        <translation>Wände zeichnen, die von beiden Seiten undurchdringlich sind</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Polygon</translation>
    </message>
    <message>
        <source>Draw a solid polygon</source>
        <translation>Ein massives Polygon zeichnen</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>K&amp;reis</translation>
    </message>
    <message>
        <source>Draw a circle from its center</source>
        <translation>Einen Kreis von seinem Mittelpunkt aus zeichnen</translation>
    </message>
    <message>
        <source>S&amp;hip</source>
        <translation>&amp;Schiff</translation>
    </message>
    <message>
        <source>Place the ship; drag to turn it</source>
        <translation>Das Schiff platzieren; Ziehen dreht es</translation>
    </message>
    <message>
        <source>Place the payload</source>
        <translation>Die Fracht platzieren</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Ziellinie</translation>
    </message>
    <message>
        <source>Draw the line that the payload has to cross</source>
        <translation>Die Linie zeichnen, die die Fracht überqueren muss</translation>
    </message>
    <message>
        <source>Rotate &amp;Left 15°</source>
        <translation>Um 15° nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn the selection anticlockwise</source>
        <translation>Die Auswahl gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Rotate &amp;Right 15°</source>
        <translation>Um 15° nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn the selection clockwise</source>
        <translation>Die Auswahl im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Rotate Left &amp;90°</source>
        <translation>Um &amp;90° nach links drehen</translation>
    </message>
    <message>
        <source>Turn the selection a quarter anticlockwise</source>
        <translation>Die Auswahl um eine Vierteldrehung gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Rotate Right 9&amp;0°</source>
        <translation>Um 9&amp;0° nach rechts drehen</translation>
    </message>
    <message>
        <source>Turn the selection a quarter clockwise</source>
        <translation>Die Auswahl um eine Vierteldrehung im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Re&amp;verse Direction</source>
        <translation>Richtung &amp;umkehren</translation>
    </message>
    <message>
        <source>Make one-way walls solid from the other side</source>
        <translation>Einseitige Kanten von der anderen Seite undurchdringlich machen</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>&amp;Nächstes Problem</translation>
    </message>
    <message>
        <source>Go to the next problem of the level</source>
        <translation>Zum nächsten Problem des Levels gehen</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>&amp;Vorheriges Problem</translation>
    </message>
    <message>
        <source>Go to the problem before</source>
        <translation>Zum vorherigen Problem gehen</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Spielen</translation>
    </message>
    <message>
        <source>Play a copy of the level, here and now</source>
        <translation>Sofort eine Kopie des Levels spielen</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>Spiel &amp;beenden</translation>
    </message>
    <message>
        <source>Pa&amp;use</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>&amp;Einzelbild weiter</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Neu starten</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>T&amp;asten…</translation>
    </message>
    <message>
        <source>Show what the keys do</source>
        <translation>Zeigen, was die Tasten bewirken</translation>
    </message>
    <message>
        <source>&amp;About SpaceTow Studio…</source>
        <translation>Ü&amp;ber SpaceTow Studio…</translation>
    </message>
    <message>
        <source>Show version and license</source>
        <translation>Version und Lizenz anzeigen</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Gruppieren</translation>
    </message>
    <message>
        <source>Make one thing of what is selected; a double click gets at its parts</source>
        <translation>Macht die Auswahl zu einem Ding; ein Doppelklick führt zu seinen Teilen</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Gruppierung &amp;aufheben</translation>
    </message>
    <message>
        <source>Take the selected groups apart</source>
        <translation>Löst die ausgewählten Gruppen auf</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Au&amp;sblenden</translation>
    </message>
    <message>
        <source>Show the selection no longer; it is played all the same</source>
        <translation>Zeigt die Auswahl nicht mehr; gespielt wird sie trotzdem</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Nur Auswahl zeigen</translation>
    </message>
    <message>
        <source>Hide everything but the selection</source>
        <translation>Blendet alles außer der Auswahl aus</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>Alles &amp;zeigen</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>Zeigt alles, was ausgeblendet ist</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>S&amp;perren</translation>
    </message>
    <message>
        <source>Keep the selection from being selected, moved and removed</source>
        <translation>Schützt die Auswahl davor, ausgewählt, verschoben und gelöscht zu werden</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>Alles &amp;entsperren</translation>
    </message>
    <message>
        <source>Let everything that is locked be changed again</source>
        <translation>Macht alles Gesperrte wieder änderbar</translation>
    </message>
    <message>
        <source>To &amp;Front</source>
        <translation>&amp;Ganz nach vorn</translation>
    </message>
    <message>
        <source>Draw the selection above everything</source>
        <translation>Zeichnet die Auswahl über allem anderen</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>&amp;Nach vorn</translation>
    </message>
    <message>
        <source>Draw the selection above the next object that overlaps it</source>
        <translation>Zeichnet die Auswahl über dem nächsten Objekt, das sie überdeckt</translation>
    </message>
    <message>
        <source>&amp;Backward</source>
        <translation>Nach &amp;hinten</translation>
    </message>
    <message>
        <source>Draw the selection below the next object that overlaps it</source>
        <translation>Zeichnet die Auswahl unter dem nächsten Objekt, mit dem sie sich überschneidet</translation>
    </message>
    <message>
        <source>To Ba&amp;ck</source>
        <translation>G&amp;anz nach hinten</translation>
    </message>
    <message>
        <source>Draw the selection below everything</source>
        <translation>Zeichnet die Auswahl unter allem anderen</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>&amp;Linke Kanten</translation>
    </message>
    <message>
        <source>Bring the left edges of the selected objects to that of the leftmost</source>
        <translation>Bringt die linken Kanten der ausgewählten Objekte zu der äußersten</translation>
    </message>
    <message>
        <source>&amp;Centers on a Vertical Line</source>
        <translation>&amp;Mitten auf eine Senkrechte</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects above each other</source>
        <translation>Bringt die Mitten der ausgewählten Objekte übereinander</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>&amp;Rechte Kanten</translation>
    </message>
    <message>
        <source>Bring the right edges of the selected objects to that of the rightmost</source>
        <translation>Bringt die rechten Kanten der ausgewählten Objekte zu der äußersten</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>&amp;Obere Kanten</translation>
    </message>
    <message>
        <source>Bring the top edges of the selected objects to that of the highest</source>
        <translation>Bringt die oberen Kanten der ausgewählten Objekte zu der höchsten</translation>
    </message>
    <message>
        <source>C&amp;enters on a Horizontal Line</source>
        <translation>Mitten &amp;auf eine Waagerechte</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects beside each other</source>
        <translation>Bringt die Mitten der ausgewählten Objekte nebeneinander</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>&amp;Untere Kanten</translation>
    </message>
    <message>
        <source>Bring the bottom edges of the selected objects to that of the lowest</source>
        <translation>Bringt die unteren Kanten der ausgewählten Objekte zu der tiefsten</translation>
    </message>
    <message>
        <source>Space Left Edges Evenly</source>
        <translation>Linke Kanten verteilen</translation>
    </message>
    <message>
        <source>Distribute the left edges between those of the outermost objects</source>
        <translation>Verteilt die linken Kanten gleichmäßig zwischen denen der äußersten Objekte</translation>
    </message>
    <message>
        <source>Space Centers Evenly Across</source>
        <translation>Mitten waagerecht verteilen</translation>
    </message>
    <message>
        <source>Distribute the centers from left to right</source>
        <translation>Verteilt die Mitten gleichmäßig von links nach rechts</translation>
    </message>
    <message>
        <source>Make &amp;Gaps Across Equal</source>
        <translation>Abstände &amp;waagerecht angleichen</translation>
    </message>
    <message>
        <source>Distribute the objects from left to right with the same gap between them</source>
        <translation>Verteilt die Objekte von links nach rechts mit gleichen Abständen</translation>
    </message>
    <message>
        <source>Space Bottom Edges Evenly</source>
        <translation>Untere Kanten verteilen</translation>
    </message>
    <message>
        <source>Distribute the bottom edges between those of the outermost objects</source>
        <translation>Verteilt die unteren Kanten gleichmäßig zwischen denen der äußersten Objekte</translation>
    </message>
    <message>
        <source>Space Centers Evenly Upwards</source>
        <translation>Mitten senkrecht verteilen</translation>
    </message>
    <message>
        <source>Distribute the centers from bottom to top</source>
        <translation>Verteilt die Mitten gleichmäßig von unten nach oben</translation>
    </message>
    <message>
        <source>Make Gaps &amp;Upwards Equal</source>
        <translation>Abstände &amp;senkrecht angleichen</translation>
    </message>
    <message>
        <source>Distribute the objects from bottom to top with the same gap between them</source>
        <translation>Verteilt die Objekte von unten nach oben mit gleichen Abständen</translation>
    </message>
    <message>
        <source>New &amp;Layer</source>
        <translation>Neue &amp;Ebene</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Above</source>
        <translation>Eine Ebene &amp;höher</translation>
    </message>
    <message>
        <source>Move the selection to the next higher layer</source>
        <translation>Verschiebt die Auswahl in die nächsthöhere Ebene</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Below</source>
        <translation>Eine Ebene &amp;tiefer</translation>
    </message>
    <message>
        <source>Move the selection to the next lower layer, or out of all layers</source>
        <translation>Verschiebt die Auswahl in die nächsttiefere Ebene oder aus allen Ebenen heraus</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Vereinigen</translation>
    </message>
    <message>
        <source>Make one body of the selected polygons</source>
        <translation>Macht aus den ausgewählten Polygonen einen Körper</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Abziehen</translation>
    </message>
    <message>
        <source>Cut the upper polygons out of the lowest one</source>
        <translation>Schneidet die oberen Polygone aus dem untersten heraus</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>Ü&amp;berschneiden</translation>
    </message>
    <message>
        <source>Keep what the selected polygons have in common</source>
        <translation>Behält, was die ausgewählten Polygone gemeinsam haben</translation>
    </message>
    <message>
        <source>Duplicat&amp;e in Place</source>
        <translation>An Or&amp;t und Stelle duplizieren</translation>
    </message>
    <message>
        <source>Copy the selection onto itself; what is done to the copy can be repeated</source>
        <translation>Kopiert die Auswahl auf sich selbst; was mit der Kopie geschieht, lässt sich wiederholen</translation>
    </message>
    <message>
        <source>Select Same &amp;Kind</source>
        <translation>&amp;Gleiche Art auswählen</translation>
    </message>
    <message>
        <source>Select all objects of the same kind as those selected</source>
        <translation>Wählt alle Objekte von der Art der ausgewählten aus</translation>
    </message>
    <message>
        <source>Select Same Ta&amp;gs</source>
        <translation>Gle&amp;iche Merkmale auswählen</translation>
    </message>
    <message>
        <source>Select all bodies with the same tags as those selected</source>
        <translation>Wählt alle Körper mit den Merkmalen der ausgewählten aus</translation>
    </message>
    <message>
        <source>Insert &amp;Midpoints</source>
        <translation>&amp;Mittelpunkte einfügen</translation>
    </message>
    <message>
        <source>Insert a node in the middle of each selected segment, or of all</source>
        <translation>Fügt in der Mitte jedes ausgewählten Segments (oder aller) einen Knoten ein</translation>
    </message>
    <message>
        <source>D&amp;elete Segments</source>
        <translation>&amp;Segmente löschen</translation>
    </message>
    <message>
        <source>Remove the segments between selected nodes and leave the chain open there</source>
        <translation>Entfernt die Segmente zwischen ausgewählten Knoten; die Kette ist dort dann offen</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>&amp;Knoten verbinden</translation>
    </message>
    <message>
        <source>Weld two end nodes, or two neighbours, into one in the middle</source>
        <translation>Verschmilzt zwei Endknoten oder zwei Nachbarn in der Mitte zu einem</translation>
    </message>
    <message>
        <source>Join by a &amp;Segment</source>
        <translation>&amp;Durch ein Segment verbinden</translation>
    </message>
    <message>
        <source>Join two end nodes by a new segment</source>
        <translation>Verbindet zwei Endknoten durch ein neues Segment</translation>
    </message>
    <message>
        <source>&amp;Break at Nodes</source>
        <translation>An Knoten &amp;trennen</translation>
    </message>
    <message>
        <source>Split chains at the selected nodes, open closed ones</source>
        <translation>Trennt Ketten an den ausgewählten Knoten, öffnet geschlossene</translation>
    </message>
    <message>
        <source>Make S&amp;traight in 15° Steps</source>
        <translation>&amp;In 15°-Schritten ausrichten</translation>
    </message>
    <message>
        <source>Turn the selected segments to the nearest multiple of 15°</source>
        <translation>Dreht die ausgewählten Segmente auf das nächste Vielfache von 15°</translation>
    </message>
    <message>
        <source>&amp;Next Node</source>
        <translation>&amp;Nächster Knoten</translation>
    </message>
    <message>
        <source>Select the next node</source>
        <translation>Wählt den nächsten Knoten aus</translation>
    </message>
    <message>
        <source>&amp;Previous Node</source>
        <translation>V&amp;origer Knoten</translation>
    </message>
    <message>
        <source>Select the previous node</source>
        <translation>Wählt den vorigen Knoten aus</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>&amp;Waagerecht spiegeln</translation>
    </message>
    <message>
        <source>Swap left and right; walls stay solid on the same side</source>
        <translation>Vertauscht links und rechts; Wände bleiben auf derselben Seite fest</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>&amp;Senkrecht spiegeln</translation>
    </message>
    <message>
        <source>Swap above and below; walls stay solid on the same side</source>
        <translation>Vertauscht oben und unten; Wände bleiben auf derselben Seite fest</translation>
    </message>
    <message>
        <source>Re&amp;peat Last Transform</source>
        <translation>Letzte &amp;Umformung wiederholen</translation>
    </message>
    <message>
        <source>Move, turn, scale or copy the selection once more as it was done last</source>
        <translation>Verschiebt, dreht, skaliert oder kopiert die Auswahl noch einmal wie zuletzt</translation>
    </message>
    <message>
        <source>&amp;Type Place and Size…</source>
        <translation>&amp;Ort und Größe eingeben…</translation>
    </message>
    <message>
        <source>Move, scale and turn the selection by numbers</source>
        <translation>Verschiebt, skaliert und dreht die Auswahl mit Zahlen</translation>
    </message>
    <message>
        <source>L&amp;inear Array…</source>
        <translation>Lineare &amp;Anordnung…</translation>
    </message>
    <message>
        <source>Make copies of the selection in a row</source>
        <translation>Macht Kopien der Auswahl in einer Reihe</translation>
    </message>
    <message>
        <source>R&amp;adial Array…</source>
        <translation>&amp;Kreisförmige Anordnung…</translation>
    </message>
    <message>
        <source>Make copies of the selection round its pivot</source>
        <translation>Macht Kopien der Auswahl rings um ihren Drehpunkt</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>K&amp;noten</translation>
    </message>
    <message>
        <source>Move, insert and delete the nodes of selected objects</source>
        <translation>Verschiebt, fügt ein und löscht Knoten der ausgewählten Objekte</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>&amp;Messer</translation>
    </message>
    <message>
        <source>Cut walls, lines and polygons along a line</source>
        <translation>Schneidet Wände, Linien und Polygone entlang einer Linie</translation>
    </message>
    <message>
        <source>Pa&amp;yload</source>
        <translation>Fr&amp;acht</translation>
    </message>
    <message>
        <source>Pl&amp;ace Ship, Payload, Finish</source>
        <translation>S&amp;chiff, Fracht, Ziellinie platzieren</translation>
    </message>
    <message>
        <source>Original Si&amp;ze</source>
        <translation>&amp;Originalgröße</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>&amp;Merkmale</translation>
    </message>
    <message>
        <source>Show names and colors of the tags of every object</source>
        <translation>Zeigt Namen und Farben der Merkmale jedes Objekts</translation>
    </message>
    <message>
        <source>Sho&amp;w What Collides</source>
        <translation>Zeigen, was &amp;kollidiert</translation>
    </message>
    <message>
        <source>Mark everything that the selection would collide with, by its tags</source>
        <translation>Markiert alles, womit die Auswahl nach ihren Merkmalen kollidieren würde</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>Su&amp;chen…</translation>
    </message>
    <message>
        <source>Find objects by name, kind or tag in the outliner</source>
        <translation>Findet Objekte in der Gliederung nach Name, Art oder Merkmal</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Um&amp;benennen…</translation>
    </message>
    <message>
        <source>Give the selected object another name, in the outliner</source>
        <translation>Gibt dem ausgewählten Objekt in der Gliederung einen anderen Namen</translation>
    </message>
    <message>
        <source>Level P&amp;roperties…</source>
        <translation>&amp;Leveleigenschaften…</translation>
    </message>
    <message>
        <source>Edit the name, rules and physics of the level itself</source>
        <translation>Ändert Namen, Regeln und Physik des Levels selbst</translation>
    </message>
    <message>
        <source>Let points land on the grid; Ctrl suspends it while it is held</source>
        <translation>Lässt Punkte am Raster einrasten; Strg setzt das aus, solange es gehalten wird</translation>
    </message>
    <message>
        <source>&amp;Coarser Grid</source>
        <translation>&amp;Gröberes Raster</translation>
    </message>
    <message>
        <source>Go on to the next larger step of the grid</source>
        <translation>Wechselt zum nächstgrößeren Rasterschritt</translation>
    </message>
    <message>
        <source>&amp;Finer Grid</source>
        <translation>&amp;Feineres Raster</translation>
    </message>
    <message>
        <source>Go on to the next smaller step of the grid</source>
        <translation>Wechselt zum nächstkleineren Rasterschritt</translation>
    </message>
    <message>
        <source>Snap to &amp;Objects</source>
        <translation>An &amp;Objekten einrasten</translation>
    </message>
    <message>
        <source>Let points land on what is in the level; Ctrl suspends it while it is held</source>
        <translation>Lässt Punkte an dem einrasten, was im Level ist; Strg setzt das aus, solange es gehalten wird</translation>
    </message>
    <message>
        <source>&amp;Vertices and Centers</source>
        <translation>&amp;Eckpunkte und Kreismitten</translation>
    </message>
    <message>
        <source>Snap to the vertices of objects, and to the centers of circles</source>
        <translation>Rastet an den Eckpunkten von Objekten und den Mittelpunkten von Kreisen ein</translation>
    </message>
    <message>
        <source>&amp;Midpoints</source>
        <translation>&amp;Mittelpunkte</translation>
    </message>
    <message>
        <source>Snap to the middles of segments</source>
        <translation>Rastet an den Mitten von Segmenten ein</translation>
    </message>
    <message>
        <source>&amp;Intersections</source>
        <translation>S&amp;chnittpunkte</translation>
    </message>
    <message>
        <source>Snap to where edges and guides cross</source>
        <translation>Rastet dort ein, wo Kanten und Hilfslinien sich kreuzen</translation>
    </message>
    <message>
        <source>&amp;Perpendiculars</source>
        <translation>&amp;Lote</translation>
    </message>
    <message>
        <source>Snap to where the way from the last point meets an edge at a right angle</source>
        <translation>Rastet dort ein, wo der Weg vom letzten Punkt im rechten Winkel auf eine Kante trifft</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Kanten</translation>
    </message>
    <message>
        <source>Snap to the edges of objects</source>
        <translation>Rastet an den Kanten von Objekten ein</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>&amp;Hilfslinien</translation>
    </message>
    <message>
        <source>Snap to guides</source>
        <translation>Rastet an Hilfslinien ein</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>&amp;Ausrichtung</translation>
    </message>
    <message>
        <source>Snap in line with the sides and middles of other objects</source>
        <translation>Rastet in einer Linie mit den Seiten und Mitten anderer Objekte ein</translation>
    </message>
    <message>
        <source>A&amp;ngles</source>
        <translation>&amp;Winkel</translation>
    </message>
    <message>
        <source>Snap to multiples of 15° from the last point; Shift keeps to them always</source>
        <translation>Rastet bei Vielfachen von 15° vom letzten Punkt aus ein; Umschalt hält sie immer ein</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>M&amp;essen</translation>
    </message>
    <message>
        <source>Measure lengths and angles</source>
        <translation>Misst Längen und Winkel</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rech&amp;teck</translation>
    </message>
    <message>
        <source>Draw a solid rectangle</source>
        <translation>Zeichnet ein massives Rechteck</translation>
    </message>
    <message>
        <source>Moving &amp;Body</source>
        <translation>&amp;Bewegter Körper</translation>
    </message>
    <message>
        <source>Draw a body that moves as it is told, and its velocity</source>
        <translation>Zeichnet einen Körper, der sich wie vorgegeben bewegt, und seine Geschwindigkeit</translation>
    </message>
    <message>
        <source>C&amp;onnector</source>
        <translation>&amp;Verbindung</translation>
    </message>
    <message>
        <source>Join two bodies by a spring or rope</source>
        <translation>Verbindet zwei Körper durch eine Feder oder ein Seil</translation>
    </message>
    <message>
        <source>&amp;Guide…</source>
        <translation>&amp;Hilfslinie…</translation>
    </message>
    <message>
        <source>Add a guide at the pointer and type where it is</source>
        <translation>Fügt am Mauszeiger eine Hilfslinie ein, deren Ort sich eingeben lässt</translation>
    </message>
    <message>
        <source>Fra&amp;me Selection</source>
        <translation>A&amp;uswahl einpassen</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>L&amp;ineale</translation>
    </message>
    <message>
        <source>Show the rulers, out of which guides are dragged</source>
        <translation>Zeigt die Lineale, aus denen sich Hilfslinien ziehen lassen</translation>
    </message>
    <message>
        <source>Guid&amp;es</source>
        <translation>Hil&amp;fslinien</translation>
    </message>
    <message>
        <source>Show the guides; what is hidden is neither taken nor snapped to</source>
        <translation>Zeigt die Hilfslinien; ausgeblendete lassen sich nicht greifen, und nichts rastet an ihnen ein</translation>
    </message>
    <message>
        <source>&amp;Delete All Guides</source>
        <translation>&amp;Alle Hilfslinien löschen</translation>
    </message>
    <message>
        <source>Take all guides out of the level</source>
        <translation>Entfernt alle Hilfslinien aus dem Level</translation>
    </message>
    <message>
        <source>Hide &amp;All</source>
        <translation>Alle a&amp;usblenden</translation>
    </message>
    <message>
        <source>Put all panels out of the way, and back as they were</source>
        <translation>Räumt alle Bedienfelder aus dem Weg und holt sie zurück, wie sie waren</translation>
    </message>
    <message>
        <source>Like &amp;the Desktop</source>
        <translation>&amp;Wie der Desktop</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is, and changing with it</source>
        <translation>Hell oder dunkel wie der Desktop und mit ihm wechselnd</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>Light panels and a white drawing board</source>
        <translation>Helle Bedienfelder und eine weiße Zeichenfläche</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>Dark panels and a drawing board as dark as space</source>
        <translation>Dunkle Bedienfelder und eine Zeichenfläche so dunkel wie das All</translation>
    </message>
    <message>
        <source>Not while a game is running.</source>
        <translation>Nicht, während ein Spiel läuft.</translation>
    </message>
    <message>
        <source>Only while a game is running.</source>
        <translation>Nur, während ein Spiel läuft.</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Zuerst etwas auswählen.</translation>
    </message>
    <message>
        <source>Select at least two objects first.</source>
        <translation>Zuerst mindestens zwei Objekte auswählen.</translation>
    </message>
    <message>
        <source>Select nodes first, with the node tool.</source>
        <translation>Zuerst mit dem Knotenwerkzeug Knoten auswählen.</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Es gibt nichts rückgängig zu machen.</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Es gibt nichts wiederherzustellen.</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Add an SVG drawing, a map of Tiled or a scene of R.U.B.E. to the level</source>
        <translation>Fügt dem Level eine SVG-Zeichnung, eine Karte von Tiled oder eine Szene von R.U.B.E. hinzu</translation>
    </message>
    <message>
        <source>&amp;Export As…</source>
        <translation>&amp;Exportieren als…</translation>
    </message>
    <message>
        <source>Write a picture of the level, as PNG or SVG</source>
        <translation>Schreibt ein Bild des Levels als PNG oder SVG</translation>
    </message>
    <message>
        <source>E&amp;xport Again</source>
        <translation>Erneut e&amp;xportieren</translation>
    </message>
    <message>
        <source>Write the picture once more, to the same file in the same way</source>
        <translation>Schreibt das Bild noch einmal auf dieselbe Weise in dieselbe Datei</translation>
    </message>
    <message>
        <source>Screens&amp;hot</source>
        <translation>Bildschirmf&amp;oto</translation>
    </message>
    <message>
        <source>Write what the canvas shows to your pictures</source>
        <translation>Speichert, was die Zeichenfläche zeigt, bei Ihren Bildern</translation>
    </message>
    <message>
        <source>Reopen Closed &amp;Level</source>
        <translation>&amp;Geschlossenes Level öffnen</translation>
    </message>
    <message>
        <source>Open again the level that was closed last</source>
        <translation>Öffnet das zuletzt geschlossene Level wieder</translation>
    </message>
    <message>
        <source>Q&amp;uick Open…</source>
        <translation>Sc&amp;hnell öffnen…</translation>
    </message>
    <message>
        <source>Find a level by a few letters of its name: recent ones, those beside it, and those that come with the program</source>
        <translation>Findet ein Level nach ein paar Buchstaben seines Namens: zuletzt geöffnete, benachbarte und mitgelieferte</translation>
    </message>
    <message>
        <source>Reloa&amp;d</source>
        <translation>Neu &amp;laden</translation>
    </message>
    <message>
        <source>Read the level from its file again; Undo brings back what it is now</source>
        <translation>Liest das Level neu aus seiner Datei; Rückgängig stellt den jetzigen Stand wieder her</translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Work…</source>
        <translation>Ungespeichertes re&amp;tten…</translation>
    </message>
    <message>
        <source>Show what was left unsaved when the program ended all of a sudden</source>
        <translation>Zeigt, was ungespeichert blieb, als das Programm plötzlich endete</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close this level and its window</source>
        <translation>Schließt dieses Level und sein Fenster</translation>
    </message>
    <message>
        <source>Close all windows and leave the program</source>
        <translation>Schließt alle Fenster und beendet das Programm</translation>
    </message>
    <message>
        <source>&amp;Find Action…</source>
        <translation>Aktion &amp;suchen…</translation>
    </message>
    <message>
        <source>Find actions, panels, levels, objects and problems by a few letters</source>
        <translation>Findet Aktionen, Bedienfelder, Level, Objekte und Probleme nach ein paar Buchstaben</translation>
    </message>
    <message>
        <source>Keyboard &amp;Shortcuts…</source>
        <translation>&amp;Tastaturkürzel…</translation>
    </message>
    <message>
        <source>Give other keys to actions, or the keys of Tiled, Inkscape or Blender</source>
        <translation>Gibt Aktionen andere Tasten oder die Tasten von Tiled, Inkscape oder Blender</translation>
    </message>
    <message>
        <source>&amp;Fix Problem</source>
        <translation>Problem &amp;beheben</translation>
    </message>
    <message>
        <source>Cure the problem that was gone to last, where there is a fix for it</source>
        <translation>Behebt das zuletzt angesteuerte Problem, wenn es dafür eine Lösung gibt</translation>
    </message>
    <message>
        <source>Fix All &amp;Safe Problems</source>
        <translation>&amp;Alles sicher Behebbare beheben</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Behebt alle Probleme, deren Lösung nichts Gewolltes ändert</translation>
    </message>
    <message>
        <source>&amp;Hide Problem</source>
        <translation>Problem a&amp;usblenden</translation>
    </message>
    <message>
        <source>Never show the problem that was gone to last in this level, or show it again</source>
        <translation>Zeigt das zuletzt angesteuerte Problem in diesem Level nie mehr oder wieder an</translation>
    </message>
    <message>
        <source>Select two nodes next to each other first, with the node tool.</source>
        <translation>Zuerst mit dem Knotenwerkzeug zwei benachbarte Knoten auswählen.</translation>
    </message>
    <message>
        <source>Select two ends of walls or lines first, with the node tool.</source>
        <translation>Zuerst mit dem Knotenwerkzeug zwei Enden von Wänden oder Linien auswählen.</translation>
    </message>
    <message>
        <source>Take the node tool and select an object first.</source>
        <translation>Zuerst das Knotenwerkzeug nehmen und ein Objekt auswählen.</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Probleme</translation>
    </message>
    <message>
        <source>Mark the places of all problems of the level</source>
        <translation>Markiert die Stellen aller Probleme des Levels</translation>
    </message>
    <message>
        <source>Compare &amp;With…</source>
        <translation>Ver&amp;gleichen mit…</translation>
    </message>
    <message>
        <source>Choose a level file and show what is different from it</source>
        <translation>Zeigt, was sich von einer gewählten Leveldatei unterscheidet</translation>
    </message>
    <message>
        <source>Only while snapping to objects is on.</source>
        <translation>Nur, wenn das Einrasten an Objekten eingeschaltet ist.</translation>
    </message>
    <message>
        <source>The level has no guides.</source>
        <translation>Das Level hat keine Hilfslinien.</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Neues &amp;Fenster</translation>
    </message>
    <message>
        <source>Start an empty level in another window</source>
        <translation>Beginnt ein leeres Level in einem weiteren Fenster</translation>
    </message>
    <message>
        <source>New &amp;View</source>
        <translation>Neue &amp;Ansicht</translation>
    </message>
    <message>
        <source>Show this level in a second window, at another place or another size</source>
        <translation>Zeigt dieses Level in einem zweiten Fenster, an anderer Stelle oder in anderer Größe</translation>
    </message>
    <message>
        <source>&amp;Next Window</source>
        <translation>&amp;Nächstes Fenster</translation>
    </message>
    <message>
        <source>Go on in the next window of the program</source>
        <translation>Wechselt zum nächsten Fenster des Programms</translation>
    </message>
    <message>
        <source>Welcome &amp;Page</source>
        <translation>&amp;Willkommensseite</translation>
    </message>
    <message>
        <source>Choose among recent levels and those that come with the program</source>
        <translation>Wählt aus zuletzt geöffneten und mitgelieferten Leveln</translation>
    </message>
    <message>
        <source>&amp;Reopen Windows at Start</source>
        <translation>Fenster beim &amp;Start wieder öffnen</translation>
    </message>
    <message>
        <source>Begin with the levels that were open when the program was left</source>
        <translation>Beginnt mit den Leveln, die beim Beenden offen waren</translation>
    </message>
    <message>
        <source>Open a level first.</source>
        <translation>Öffnen Sie zuerst ein Level.</translation>
    </message>
    <message>
        <source>No level has been closed yet.</source>
        <translation>Es wurde noch kein Level geschlossen.</translation>
    </message>
    <message>
        <source>The level has no file yet.</source>
        <translation>Das Level hat noch keine Datei.</translation>
    </message>
    <message>
        <source>Go to a problem first for which there is a fix.</source>
        <translation>Gehen Sie zuerst zu einem Problem, das sich beheben lässt.</translation>
    </message>
    <message>
        <source>There is no problem that could be cured without asking.</source>
        <translation>Es gibt kein Problem, das sich ohne Rückfrage beheben lässt.</translation>
    </message>
    <message>
        <source>Go to a problem first.</source>
        <translation>Gehen Sie zuerst zu einem Problem.</translation>
    </message>
    <message>
        <source>The grid is as coarse as it gets.</source>
        <translation>Gröber geht das Raster nicht.</translation>
    </message>
    <message>
        <source>The grid is as fine as it gets.</source>
        <translation>Feiner geht das Raster nicht.</translation>
    </message>
    <message>
        <source>This window stands alone.</source>
        <translation>Dieses Fenster steht für sich.</translation>
    </message>
    <message>
        <source>There is no other window.</source>
        <translation>Es gibt kein anderes Fenster.</translation>
    </message>
    <message>
        <source>Show the bounding box of every body, and that of the broad phase</source>
        <translation>Das Hüllrechteck jedes Körpers und das der Grobphase anzeigen</translation>
    </message>
    <message>
        <source>Show the free side of every wall, and the solid band behind it</source>
        <translation>Die freie Seite jeder Wand und den massiven Streifen dahinter anzeigen</translation>
    </message>
    <message>
        <source>&amp;Quadtrees</source>
        <translation>&amp;Quadtrees</translation>
    </message>
    <message>
        <source>Show the cells in which collisions are looked for, and what they hold</source>
        <translation>Die Zellen anzeigen, in denen nach Kollisionen gesucht wird, und was sie enthalten</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>K&amp;ontakte</translation>
    </message>
    <message>
        <source>Show where bodies touch, and the forces between them</source>
        <translation>Anzeigen, wo Körper sich berühren, und die Kräfte zwischen ihnen</translation>
    </message>
    <message>
        <source>T&amp;ension</source>
        <translation>Spannun&amp;g</translation>
    </message>
    <message>
        <source>Show how much every rope and connector pulls</source>
        <translation>Anzeigen, wie stark jedes Seil und jede Verbindung zieht</translation>
    </message>
    <message>
        <source>T&amp;rails</source>
        <translation>&amp;Bahnen</translation>
    </message>
    <message>
        <source>Show the way that every body has gone, or will go at first</source>
        <translation>Den Weg anzeigen, den jeder Körper gegangen ist oder anfangs gehen wird</translation>
    </message>
    <message>
        <source>Centers of &amp;Mass</source>
        <translation>Sch&amp;werpunkte</translation>
    </message>
    <message>
        <source>Show the center of mass of every body</source>
        <translation>Den Schwerpunkt jedes Körpers anzeigen</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Namen</translation>
    </message>
    <message>
        <source>Show the name of every object that has one</source>
        <translation>Den Namen jedes Objekts anzeigen, das einen hat</translation>
    </message>
    <message>
        <source>I&amp;slands and Sleep</source>
        <translation>Inseln und &amp;Schlaf</translation>
    </message>
    <message>
        <source>Show which bodies may push each other, and which ones sleep</source>
        <translation>Anzeigen, welche Körper einander schieben können und welche schlafen</translation>
    </message>
    <message>
        <source>Ris&amp;k of Passing Through</source>
        <translation>&amp;Durchdringungsgefahr</translation>
    </message>
    <message>
        <source>Show how far through each wall one iteration may carry what approaches it</source>
        <translation>Bei jeder Wand anzeigen, wie weit eine Iteration hindurchtragen kann, was auf sie zukommt</translation>
    </message>
    <message>
        <source>Reach o&amp;f the Ship</source>
        <translation>&amp;Reichweite des Schiffs</translation>
    </message>
    <message>
        <source>Show where the ship, and the payload on its rope, can be in the next seconds: from its start, or from where it is in a run that is paused</source>
        <translation>Anzeigen, wo das Schiff und die Fracht an seinem Seil in den nächsten Sekunden sein können: ab dem Start oder, in einem angehaltenen Lauf, ab ihrem jetzigen Ort</translation>
    </message>
    <message>
        <source>Reach a Second Longer</source>
        <translation>Reichweite eine Sekunde länger</translation>
    </message>
    <message>
        <source>Look a second further ahead, up to five</source>
        <translation>Eine Sekunde weiter vorausschauen, bis zu fünf</translation>
    </message>
    <message>
        <source>Reach a Second Shorter</source>
        <translation>Reichweite eine Sekunde kürzer</translation>
    </message>
    <message>
        <source>Look less far ahead, down to one second</source>
        <translation>Weniger weit vorausschauen, bis hinab zu einer Sekunde</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>&amp;Legende</translation>
    </message>
    <message>
        <source>Explain the colors of the overlays that are on, in a corner of the canvas</source>
        <translation>Die Farben der eingeschalteten Einblendungen in einer Ecke der Zeichenfläche erklären</translation>
    </message>
    <message>
        <source>Color-Blind-Safe Colors</source>
        <translation>Farben für Farbenblinde</translation>
    </message>
    <message>
        <source>Draw the overlays in the colors of Okabe and Ito, which everybody tells apart</source>
        <translation>Die Einblendungen in den Farben von Okabe und Ito zeichnen, die alle unterscheiden können</translation>
    </message>
    <message>
        <source>Forget Own Colors</source>
        <translation>Eigene Farben vergessen</translation>
    </message>
    <message>
        <source>Give all overlays the colors of the set again</source>
        <translation>Allen Einblendungen wieder die Farben des Farbsatzes geben</translation>
    </message>
    <message>
        <source>No overlay has a color of your own: click one in the legend.</source>
        <translation>Keine Einblendung hat eine eigene Farbe: Klicken Sie in der Legende auf eine.</translation>
    </message>
    <message>
        <source>S&amp;imulate</source>
        <translation>S&amp;imulieren</translation>
    </message>
    <message>
        <source>Let the bodies of the level move in place, and go on editing beside</source>
        <translation>Die Körper des Levels an Ort und Stelle bewegen und daneben weiter bearbeiten</translation>
    </message>
    <message>
        <source>The level runs already.</source>
        <translation>Das Level läuft schon.</translation>
    </message>
    <message>
        <source>Play fr&amp;om Pointer</source>
        <translation>Ab &amp;Mauszeiger spielen</translation>
    </message>
    <message>
        <source>Play a copy of the level in which the ship starts where the pointer is</source>
        <translation>Eine Kopie des Levels spielen, in der das Schiff am Mauszeiger startet</translation>
    </message>
    <message>
        <source>Go back to the drawing board</source>
        <translation>Zur Zeichenfläche zurückkehren</translation>
    </message>
    <message>
        <source>Hold what runs, or let it go on</source>
        <translation>Den Lauf anhalten oder fortsetzen</translation>
    </message>
    <message>
        <source>Hold what runs and advance it by one update</source>
        <translation>Den Lauf anhalten und um einen Zeitschritt weiterrücken</translation>
    </message>
    <message>
        <source>Run the level from its beginning</source>
        <translation>Das Level von Anfang an laufen lassen</translation>
    </message>
    <message>
        <source>Pre&amp;vious Frame</source>
        <translation>Einzelbild &amp;zurück</translation>
    </message>
    <message>
        <source>Hold what runs and go back by one update</source>
        <translation>Den Lauf anhalten und um einen Zeitschritt zurückgehen</translation>
    </message>
    <message>
        <source>Next I&amp;teration</source>
        <translation>Nächste I&amp;teration</translation>
    </message>
    <message>
        <source>Hold what runs and look into the next update, one iteration further</source>
        <translation>Den Lauf anhalten und in den nächsten Zeitschritt hineinsehen, eine Iteration weiter</translation>
    </message>
    <message>
        <source>To the &amp;Beginning</source>
        <translation>Zum &amp;Anfang</translation>
    </message>
    <message>
        <source>Hold what runs and go back as far as it is kept</source>
        <translation>Den Lauf anhalten und so weit zurückgehen, wie er aufbewahrt ist</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>Zum En&amp;de</translation>
    </message>
    <message>
        <source>Hold what runs and show its last moment</source>
        <translation>Den Lauf anhalten und seinen letzten Augenblick zeigen</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Let time run half as fast; [ does so on the canvas</source>
        <translation>Die Zeit halb so schnell laufen lassen; [ tut das auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>Let time run twice as fast; ] does so on the canvas</source>
        <translation>Die Zeit doppelt so schnell laufen lassen; ] tut das auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>&amp;Follow the Ship</source>
        <translation>Dem Schiff &amp;folgen</translation>
    </message>
    <message>
        <source>Let the view go with the ship again, after it has been moved</source>
        <translation>Die Ansicht wieder mit dem Schiff mitgehen lassen, nachdem sie verschoben wurde</translation>
    </message>
    <message>
        <source>Only in a game is there a ship to follow.</source>
        <translation>Nur im Spiel gibt es ein Schiff, dem sich folgen lässt.</translation>
    </message>
    <message>
        <source>Save Fli&amp;ght…</source>
        <translation>Fl&amp;ug speichern…</translation>
    </message>
    <message>
        <source>Write what has been flown into a file that can be dropped on a window</source>
        <translation>Den bisherigen Flug in eine Datei schreiben, die sich auf ein Fenster ziehen lässt</translation>
    </message>
    <message>
        <source>Copy &amp;Bug Capsule</source>
        <translation>Fehler&amp;kapsel kopieren</translation>
    </message>
    <message>
        <source>Copy the level and the run up to this moment as text, for a mail or an issue; pasted into a window, it opens at the same moment</source>
        <translation>Level und Lauf bis zu diesem Moment als Text kopieren, für eine E-Mail oder eine Fehlermeldung; in ein Fenster eingefügt, öffnet er sich im selben Moment</translation>
    </message>
    <message>
        <source>In a game only while its panels are shown.</source>
        <translation>In einem Spiel nur, solange seine Paletten gezeigt werden.</translation>
    </message>
    <message>
        <source>Overlay Colors…</source>
        <translation>Farben der Einblendungen …</translation>
    </message>
    <message>
        <source>Choose the set of colors of the overlays, and colors of your own for each</source>
        <translation>Die Farbpalette der Einblendungen wählen und eigene Farben für jede</translation>
    </message>
    <message>
        <source>Wa&amp;ys of a Run</source>
        <translation>Wege eines Lau&amp;fs</translation>
    </message>
    <message>
        <source>Show the ways of the last minute where a run is held, and those of futures given up</source>
        <translation>Die Wege der letzten Minute zeigen, wo ein Lauf angehalten ist, und die aufgegebener Zukünfte</translation>
    </message>
    <message>
        <source>What is selected is locked.</source>
        <translation>Was ausgewählt ist, ist gesperrt.</translation>
    </message>
    <message>
        <source>Ship, payload and finish exist once, and connectors are copied with their two bodies.</source>
        <translation>Schiff, Fracht und Ziellinie gibt es nur einmal, und Verbindungen werden mit ihren beiden Körpern kopiert.</translation>
    </message>
    <message>
        <source>Select a wall or a line first.</source>
        <translation>Zuerst eine Kante oder Linie auswählen.</translation>
    </message>
    <message>
        <source>Select a group first.</source>
        <translation>Zuerst eine Gruppe auswählen.</translation>
    </message>
    <message>
        <source>What is selected has no nodes.</source>
        <translation>Was ausgewählt ist, hat keine Knoten.</translation>
    </message>
    <message>
        <source>“%1” changes nothing here.</source>
        <translation>„%1“ ändert hier nichts.</translation>
    </message>
    <message>
        <source>Put the selection into a new layer, or make an empty one, and type its name</source>
        <translation>Die Auswahl in eine neue Ebene legen oder eine leere anlegen und ihren Namen eingeben</translation>
    </message>
    <message>
        <source>Insert Node &amp;Here</source>
        <translation>Knoten &amp;hier einfügen</translation>
    </message>
    <message>
        <source>Insert a node where the pointer is at an edge of the selection</source>
        <translation>Einen Knoten einfügen, wo der Zeiger an einer Kante der Auswahl ist</translation>
    </message>
    <message>
        <source>Not while the level runs.</source>
        <translation>Nicht, während das Level läuft.</translation>
    </message>
    <message>
        <source>Place ship, payload or finish, first what the level lacks; again for the next of them</source>
        <translation>Schiff, Fracht oder Ziellinie setzen, zuerst was dem Level fehlt; noch einmal für das nächste</translation>
    </message>
</context>
<context>
    <name>BugCapsule</name>
    <message>
        <source>Another bug capsule is still being worked on.</source>
        <translation>An einer anderen Fehlerkapsel wird noch gearbeitet.</translation>
    </message>
    <message>
        <source>A bug capsule of %1 is on the clipboard. Paste it into a mail or an issue, or into a window of this program.</source>
        <translation>Eine Fehlerkapsel von %1 ist in der Zwischenablage. Fügen Sie sie in eine E-Mail, eine Fehlermeldung oder ein Fenster dieses Programms ein.</translation>
    </message>
    <message>
        <source>The run comes out otherwise here than where the bug capsule was made, with %1 on %2.</source>
        <translation>Der Lauf verläuft hier anders als dort, wo die Fehlerkapsel entstand, mit %1 auf %2.</translation>
    </message>
    <message>
        <source>The bug capsule is being read…</source>
        <translation>Die Fehlerkapsel wird gelesen …</translation>
    </message>
    <message>
        <source>The bug capsule</source>
        <translation>Die Fehlerkapsel</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
</context>
<context>
    <name>Compared</name>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>all but %1</source>
        <translation>alle außer %1</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Level: %1</source>
        <translation>Level: %1</translation>
    </message>
    <message>
        <source>Guide %1: added</source>
        <translation>Hilfslinie %1: hinzugefügt</translation>
    </message>
    <message>
        <source>Guide %1: removed</source>
        <translation>Hilfslinie %1: entfernt</translation>
    </message>
    <message>
        <source>Level: fields that this program does not know</source>
        <translation>Level: Felder, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>Level: other problems are hidden</source>
        <translation>Level: andere Probleme sind ausgeblendet</translation>
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
        <translation>Merkmal „%1“: hinzugefügt</translation>
    </message>
    <message>
        <source>Tag “%1”: removed</source>
        <translation>Merkmal „%1“: entfernt</translation>
    </message>
    <message>
        <source>Tag “%1”: renamed to “%2”</source>
        <translation>Merkmal „%1“: umbenannt in „%2“</translation>
    </message>
    <message>
        <source>Tag “%1”: color %2 → %3</source>
        <translation>Merkmal „%1“: Farbe %2 → %3</translation>
    </message>
    <message>
        <source>added</source>
        <translation>hinzugefügt</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>entfernt</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>war %1</translation>
    </message>
    <message>
        <source>shape moved</source>
        <translation>Form verschoben</translation>
    </message>
    <message>
        <source>shape changed</source>
        <translation>Form geändert</translation>
    </message>
    <message>
        <source>shape changed, points %1 → %2</source>
        <translation>Form geändert, Punkte %1 → %2</translation>
    </message>
    <message>
        <source>drawn in another place</source>
        <translation>an anderer Stelle gezeichnet</translation>
    </message>
    <message>
        <source>fields that this program does not know</source>
        <translation>Felder, die dieses Programm nicht kennt</translation>
    </message>
    <message>
        <source>The level</source>
        <translation>Das Level</translation>
    </message>
    <message>
        <source>%1: both sides changed “%2”.</source>
        <translation>%1: Beide Seiten haben „%2“ geändert.</translation>
    </message>
    <message>
        <source>%1: both sides made something else of it.</source>
        <translation>%1: Beide Seiten haben etwas anderes daraus gemacht.</translation>
    </message>
    <message>
        <source>%1: both sides added another object under the key %2.</source>
        <translation>%1: Beide Seiten haben ein anderes Objekt mit dem Schlüssel %2 hinzugefügt.</translation>
    </message>
    <message>
        <source>%1: our side removed it, their side changed or needs it. It stays.</source>
        <translation>%1: Unsere Seite hat es entfernt, die andere hat es geändert oder braucht es. Es bleibt.</translation>
    </message>
    <message>
        <source>%1: their side removed it, our side changed or needs it. It stays.</source>
        <translation>%1: Die andere Seite hat es entfernt, unsere hat es geändert oder braucht es. Es bleibt.</translation>
    </message>
    <message>
        <source>%1: groups would be in each other. It stays in the group that our side has put it in.</source>
        <translation>%1: Gruppen lägen ineinander. Es bleibt in der Gruppe, in die unsere Seite es gelegt hat.</translation>
    </message>
    <message>
        <source>%1: both sides changed the order of drawing.</source>
        <translation>%1: Beide Seiten haben die Zeichenreihenfolge geändert.</translation>
    </message>
    <message>
        <source>There is no room for the tag “%1” of their side among the 32 tags.</source>
        <translation>Für das Merkmal „%1“ der anderen Seite ist unter den 32 Merkmalen kein Platz.</translation>
    </message>
    <message>
        <source>Guides: in another order</source>
        <translation>Hilfslinien: in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>at %1; %2</source>
        <translation>bei %1; %2</translation>
    </message>
</context>
<context>
    <name>CrashWords</name>
    <message>
        <source>The ship hit the payload.</source>
        <translation>Das Schiff ist gegen die Fracht gestoßen.</translation>
    </message>
    <message>
        <source>The ship hit “%1”.</source>
        <translation>Das Schiff ist gegen „%1“ gestoßen.</translation>
    </message>
    <message>
        <source>The payload hit “%1”.</source>
        <translation>Die Fracht ist gegen „%1“ gestoßen.</translation>
    </message>
    <message>
        <source>The ship hit something tagged “%1”.</source>
        <translation>Das Schiff ist gegen etwas mit dem Merkmal „%1“ gestoßen.</translation>
    </message>
    <message>
        <source>The payload hit something tagged “%1”.</source>
        <translation>Die Fracht ist gegen etwas mit dem Merkmal „%1“ gestoßen.</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a flight in the level “%2”, which is neither open nor beside it. Open the level and drop the flight on it.</source>
        <translation>%1 ist ein Flug im Level „%2“, das weder offen ist noch daneben liegt. Öffnen Sie das Level und ziehen Sie den Flug darauf.</translation>
    </message>
    <message>
        <source>The level has been changed since the flight was recorded, which may therefore end otherwise.</source>
        <translation>Das Level wurde seit der Aufzeichnung des Flugs geändert; er kann deshalb anders enden.</translation>
    </message>
    <message>
        <source>Files of other programs are imported one at a time, as each is looked at first: of these it is %1.</source>
        <translation>Dateien anderer Programme werden einzeln importiert, da jede zuerst angesehen wird: Von diesen ist es %1.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the flight.</source>
        <translation>Der Speicher reicht nicht, um den Flug zu lesen.</translation>
    </message>
    <message>
        <source>%1 is a simulation of the level “%2”, which is neither open nor beside it. Open the level and drop the simulation on it.</source>
        <translation>%1 ist eine Simulation des Levels „%2“, das weder offen ist noch daneben liegt. Öffnen Sie das Level und lassen Sie die Simulation darauf fallen.</translation>
    </message>
    <message>
        <source>The level has been changed since the simulation was recorded, which may therefore go otherwise.</source>
        <translation>Das Level wurde geändert, seit die Simulation aufgezeichnet wurde; sie kann daher anders verlaufen.</translation>
    </message>
</context>
<context>
    <name>Explain</name>
    <message>
        <source>Debris</source>
        <translation>Trümmer</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Kräfte</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Thrust and steering</source>
        <translation>Schub und Steuerung</translation>
    </message>
    <message>
        <source>Pulled by the mouse</source>
        <translation>Zug der Maus</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Zusammen</translation>
    </message>
    <message>
        <source>felt, without a force</source>
        <translation>gespürt, ohne Kraft</translation>
    </message>
    <message>
        <source>%1, of which friction %2</source>
        <translation>%1, davon Reibung %2</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Tags touched</source>
        <translation>Berührte Merkmale</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Dreht sich</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Kinetische Energie</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>Potenzielle Energie</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Eigendrehimpuls</translation>
    </message>
    <message>
        <source>Angular momentum</source>
        <translation>Drehimpuls</translation>
    </message>
    <message>
        <source>Sleeps</source>
        <translation>Schläft</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Distance of its ends</source>
        <translation>Abstand der Enden</translation>
    </message>
    <message>
        <source>Natural length</source>
        <translation>Natürliche Länge</translation>
    </message>
    <message>
        <source>Pushes with</source>
        <translation>Drückt mit</translation>
    </message>
    <message>
        <source>Pulls with</source>
        <translation>Zieht mit</translation>
    </message>
    <message>
        <source>Elastic energy</source>
        <translation>Elastische Energie</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Zwischen</translation>
    </message>
    <message>
        <source>All bodies</source>
        <translation>Alle Körper</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>Gesamtenergie</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>There is not enough memory to open the file.</source>
        <translation>Der Speicher reicht nicht aus, um die Datei zu öffnen.</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>%1 wird gelesen …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>SpaceTow levels (*.json);;All files (*)</source>
        <translation>SpaceTow-Level (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Änderungen an „%1“ speichern?</translation>
    </message>
    <message>
        <source>If you discard them, they are lost.</source>
        <translation>Wenn Sie sie verwerfen, gehen sie verloren.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>Open level</source>
        <translation>Level öffnen</translation>
    </message>
    <message>
        <source>Save level as</source>
        <translation>Level speichern unter</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>level</source>
        <translation>level</translation>
    </message>
    <message>
        <source>The example</source>
        <translation>Das Beispiel</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>%1 was opened, but:</source>
        <translation>%1 wurde geöffnet, aber:</translation>
    </message>
    <message>
        <source>Nothing is lost: your work is still here. Save it elsewhere?</source>
        <translation>Nichts ist verloren: Ihre Arbeit ist noch da. An anderer Stelle speichern?</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>What was kept of %1 cannot be read.</source>
        <translation>Was von %1 aufbewahrt wurde, lässt sich nicht lesen.</translation>
    </message>
    <message>
        <source>Open Newest Backup</source>
        <translation>Neueste Sicherung öffnen</translation>
    </message>
    <message>
        <source>This is the newest backup of %1. The file stays as it is until you save.</source>
        <translation>Dies ist die neueste Sicherung von %1. Die Datei bleibt, wie sie ist, bis Sie speichern.</translation>
    </message>
    <message>
        <source>This backup cannot be opened.</source>
        <translation>Diese Sicherung lässt sich nicht öffnen.</translation>
    </message>
    <message>
        <source>%1 is saved, but of the version before no backup could be made:</source>
        <translation>%1 ist gespeichert, aber von der Fassung davor konnte keine Sicherung angelegt werden:</translation>
    </message>
    <message>
        <source>Compare with level</source>
        <translation>Mit Level vergleichen</translation>
    </message>
</context>
<context>
    <name>FlightFile</name>
    <message>
        <source>The flight has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>Der Flug wurde als %1 gespeichert. Ziehen Sie die Datei auf ein Fenster, um ihn wieder anzusehen.</translation>
    </message>
    <message>
        <source>The simulation has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>Die Simulation wurde als %1 gespeichert. Ziehen Sie die Datei auf ein Fenster, um sie wieder anzusehen.</translation>
    </message>
    <message>
        <source>It ends after %1 of %2 updates: a file holds no more.</source>
        <translation>Sie endet nach %1 von %2 Schritten: mehr fasst eine Datei nicht.</translation>
    </message>
    <message>
        <source>Another recording is still being saved.</source>
        <translation>Eine andere Aufzeichnung wird noch gespeichert.</translation>
    </message>
</context>
<context>
    <name>FlightsPanel</name>
    <message>
        <source>wins after %1 s, with %2 s of thrust</source>
        <translation>gewinnt nach %1 s, mit %2 s Schub</translation>
    </message>
    <message>
        <source>is being flown…</source>
        <translation>wird geflogen…</translation>
    </message>
    <message>
        <source>still wins, after %1 s</source>
        <translation>gewinnt weiterhin, nach %1 s</translation>
    </message>
    <message>
        <source>still wins, now after %1 s; before after %2 s</source>
        <translation>gewinnt weiterhin, jetzt nach %1 s; vorher nach %2 s</translation>
    </message>
    <message>
        <source>crashed before, wins now after %1 s</source>
        <translation>ist vorher abgestürzt, gewinnt jetzt nach %1 s</translation>
    </message>
    <message>
        <source>was not won before, wins now after %1 s</source>
        <translation>wurde vorher nicht gewonnen, gewinnt jetzt nach %1 s</translation>
    </message>
    <message>
        <source>still crashes at %1, after %2 s</source>
        <translation>stürzt weiterhin bei %1 ab, nach %2 s</translation>
    </message>
    <message>
        <source>still crashes, now at %1, after %2 s; before after %3 s</source>
        <translation>stürzt weiterhin ab, jetzt bei %1, nach %2 s; vorher nach %3 s</translation>
    </message>
    <message>
        <source>won before, crashes now at %1, after %2 s</source>
        <translation>hat vorher gewonnen, stürzt jetzt bei %1 ab, nach %2 s</translation>
    </message>
    <message>
        <source>crashes now, at %1, after %2 s</source>
        <translation>stürzt jetzt ab, bei %1, nach %2 s</translation>
    </message>
    <message>
        <source>crashes at %1, after %2 s</source>
        <translation>stürzt bei %1 ab, nach %2 s</translation>
    </message>
    <message>
        <source>won before, now there is no ship</source>
        <translation>hat vorher gewonnen, jetzt fehlt das Schiff</translation>
    </message>
    <message>
        <source>runs to its end</source>
        <translation>läuft bis zum Ende</translation>
    </message>
    <message>
        <source>is still under way at its end, at %1</source>
        <translation>ist am Ende weiterhin unterwegs, bei %1</translation>
    </message>
    <message>
        <source>is still under way at its end, now at %1</source>
        <translation>ist am Ende weiterhin unterwegs, jetzt bei %1</translation>
    </message>
    <message>
        <source>won before, now is under way at its end, at %1</source>
        <translation>hat vorher gewonnen, ist jetzt am Ende noch unterwegs, bei %1</translation>
    </message>
    <message>
        <source>crashed before, now is under way at its end, at %1</source>
        <translation>ist vorher abgestürzt, ist jetzt am Ende noch unterwegs, bei %1</translation>
    </message>
    <message>
        <source>is under way at its end, at %1</source>
        <translation>ist am Ende noch unterwegs, bei %1</translation>
    </message>
    <message>
        <source>cannot be flown: too many bodies lie in the same place. Move them apart.</source>
        <translation>kann nicht geflogen werden: Zu viele Körper liegen an derselben Stelle. Schieben Sie sie auseinander.</translation>
    </message>
    <message>
        <source>is a simulation of %1 s</source>
        <translation>ist eine Simulation von %1 s</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
</context>
<context>
    <name>Forces</name>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>Ausgeübt</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
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
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Press a direction to start</source>
        <translation>Zum Starten eine Richtung drücken</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Abgestürzt</translation>
    </message>
    <message>
        <source>Press any key to try again</source>
        <translation>Beliebige Taste: noch einmal versuchen</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Game over</translation>
    </message>
    <message>
        <source>No life is left. Press any key to start the level over</source>
        <translation>Kein Leben mehr übrig. Beliebige Taste: Level neu beginnen</translation>
    </message>
    <message>
        <source>You made it!</source>
        <translation>Geschafft!</translation>
    </message>
    <message>
        <source>Lives %1</source>
        <translation>Leben %1</translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation>Zeit %1</translation>
    </message>
    <message>
        <source>Fuel used %1 s</source>
        <translation>Treibstoff %1 s</translation>
    </message>
    <message>
        <source>Gravity is upside down!</source>
        <translation>Die Schwerkraft steht kopf!</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>Menü</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a key and what it does</comment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The payload is home.</source>
        <translation>Die Fracht ist zu Hause.</translation>
    </message>
    <message>
        <source>fly again</source>
        <translation>noch einmal fliegen</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>weiter</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>ein Schritt</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>tow</source>
        <translation>schleppen</translation>
    </message>
    <message>
        <source>In range.</source>
        <translation>In Reichweite.</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>drehen</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>Take the payload in tow and carry it across the finish.</source>
        <translation>Nehmen Sie die Fracht in Schlepp und bringen Sie sie über die Ziellinie.</translation>
    </message>
    <message>
        <source>Ship and payload are lost.</source>
        <translation>Schiff und Fracht sind verloren.</translation>
    </message>
    <message>
        <source>The ship is lost.</source>
        <translation>Das Schiff ist verloren.</translation>
    </message>
    <message>
        <source>The payload is lost.</source>
        <translation>Die Fracht ist verloren.</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Static</source>
        <translation>Statisch</translation>
    </message>
    <message>
        <source>Kinematic</source>
        <translation>Kinematisch</translation>
    </message>
    <message>
        <source>Dynamic</source>
        <translation>Dynamisch</translation>
    </message>
    <message>
        <source>No tension</source>
        <translation>Keine Spannung</translation>
    </message>
    <message>
        <source>Unlimited</source>
        <translation>Unbegrenzt</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Gekappt</translation>
    </message>
    <message>
        <source>Tanh</source>
        <translation>Tanh</translation>
    </message>
    <message>
        <source>Partial tanh</source>
        <translation>Teilweise Tanh</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Kollisionen</translation>
    </message>
    <message>
        <source>Rules of the game</source>
        <translation>Spielregeln</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Physik</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>no back</source>
        <translation>keine Rückseite</translation>
    </message>
    <message>
        <source>Closed: the last point joins the first</source>
        <translation>Geschlossen: Ende trifft Anfang</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>from shape</source>
        <translation>aus der Form</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Stoßzahl</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Drehrate</translation>
    </message>
    <message>
        <source>Linear damping</source>
        <translation>Lineare Dämpfung</translation>
    </message>
    <message>
        <source>Angular damping</source>
        <translation>Drehdämpfung</translation>
    </message>
    <message>
        <source>Frozen: held in place</source>
        <translation>Eingefroren: bleibt am Ort</translation>
    </message>
    <message>
        <source>Anchor on first</source>
        <translation>Anker am ersten</translation>
    </message>
    <message>
        <source>Anchor on second</source>
        <translation>Anker am zweiten</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>as placed</source>
        <translation>wie platziert</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Untouched part</source>
        <translation>Freier Anteil</translation>
    </message>
    <message>
        <source>Slack: pulls only</source>
        <translation>Schlaff: zieht nur</translation>
    </message>
    <message>
        <source>Its two bodies may collide</source>
        <translation>Beide Körper dürfen kollidieren</translation>
    </message>
    <message>
        <source>Tangible: others bounce off it</source>
        <translation>Greifbar: anderes prallt ab</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Berührt</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Hintergrund</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Leben</translation>
    </message>
    <message>
        <source>Tow range</source>
        <translation>Schleppweite</translation>
    </message>
    <message>
        <source>Towing turns gravity round</source>
        <translation>Schleppen kehrt Schwerkraft um</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Sub-steps</source>
        <translation>Teilschritte</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>For people; several objects may share one</source>
        <translation>Für Menschen; mehrere Objekte dürfen denselben haben</translation>
    </message>
    <message>
        <source>Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey forces</source>
        <translation>Statische Körper bewegen sich nie, kinematische bewegen sich wie vorgegeben und werden von nichts geschoben, dynamische gehorchen Kräften</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Name or key of the group that it is in; nothing for none</source>
        <translation>Name oder Schlüssel der Gruppe, in der es ist; leer: in keiner</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Of the group&apos;s mark and of what is selected in it</source>
        <translation>Für die Markierung der Gruppe und für das, was darin ausgewählt ist</translation>
    </message>
    <message>
        <source>Layer: a group at the top</source>
        <translation>Ebene: eine Gruppe ganz oben</translation>
    </message>
    <message>
        <source>Visible in the editor</source>
        <translation>Im Editor sichtbar</translation>
    </message>
    <message>
        <source>Locked: cannot be picked or moved</source>
        <translation>Gesperrt: weder wählbar noch verschiebbar</translation>
    </message>
    <message>
        <source>Where the origin of the object is</source>
        <translation>Wo der Ursprung des Objekts liegt</translation>
    </message>
    <message>
        <source>Anticlockwise. Plain numbers are degrees; write “rad” after radians</source>
        <translation>Gegen den Uhrzeigersinn. Bloße Zahlen sind Grad; für Radiant steht „rad“ dahinter</translation>
    </message>
    <message>
        <source>One end of the finish</source>
        <translation>Ein Ende der Ziellinie</translation>
    </message>
    <message>
        <source>The other end of the finish</source>
        <translation>Das andere Ende der Ziellinie</translation>
    </message>
    <message>
        <source>Center</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>Middle of the circle in the coordinates of its body</source>
        <translation>Mitte des Kreises in den Koordinaten seines Körpers</translation>
    </message>
    <message>
        <source>From the middle to the rim</source>
        <translation>Von der Mitte zum Rand</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>How many corners the shape has; move them on the canvas</source>
        <translation>Wie viele Ecken die Form hat; auf der Zeichenfläche lassen sie sich verschieben</translation>
    </message>
    <message>
        <source>How far behind the line counts as inside the wall; nothing for a wall without a back</source>
        <translation>Wie weit hinter der Linie noch als in der Wand gilt; leer bei einer Wand ohne Rückseite</translation>
    </message>
    <message>
        <source>Nothing: area times density</source>
        <translation>Leer: Fläche mal Dichte</translation>
    </message>
    <message>
        <source>Counts while no mass is given; a metre of wall weighs 1 kg times the density</source>
        <translation>Zählt, solange keine Masse angegeben ist; ein Meter Wand wiegt 1 kg mal die Dichte</translation>
    </message>
    <message>
        <source>Share of the speed that is left after a bounce</source>
        <translation>Anteil der Geschwindigkeit, der nach einem Aufprall bleibt</translation>
    </message>
    <message>
        <source>Coefficient of friction: force along a surface per force on it</source>
        <translation>Reibungszahl: Kraft entlang einer Fläche je Kraft auf sie</translation>
    </message>
    <message>
        <source>Of the center of mass at the start</source>
        <translation>Des Schwerpunkts beim Start</translation>
    </message>
    <message>
        <source>Turning at the start, anticlockwise</source>
        <translation>Drehung beim Start, gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Share of the velocity that is lost each second</source>
        <translation>Anteil der Geschwindigkeit, der jede Sekunde verloren geht</translation>
    </message>
    <message>
        <source>Share of the spin that is lost each second</source>
        <translation>Anteil der Drehrate, der jede Sekunde verloren geht</translation>
    </message>
    <message>
        <source>First body</source>
        <translation>Erster Körper</translation>
    </message>
    <message>
        <source>Name or key of the body that it holds</source>
        <translation>Name oder Schlüssel des Körpers, den sie hält</translation>
    </message>
    <message>
        <source>Second body</source>
        <translation>Zweiter Körper</translation>
    </message>
    <message>
        <source>Name or key of the other body that it holds</source>
        <translation>Name oder Schlüssel des anderen Körpers, den sie hält</translation>
    </message>
    <message>
        <source>Where it holds the first body, in the coordinates of that</source>
        <translation>Wo sie den ersten Körper hält, in dessen Koordinaten</translation>
    </message>
    <message>
        <source>Where it holds the second body, in the coordinates of that</source>
        <translation>Wo sie den zweiten Körper hält, in dessen Koordinaten</translation>
    </message>
    <message>
        <source>At which it neither pulls nor pushes; nothing: the distance at the start</source>
        <translation>Bei der sie weder zieht noch drückt; leer: der Abstand beim Start</translation>
    </message>
    <message>
        <source>Force per metre of stretch</source>
        <translation>Kraft je Meter Dehnung</translation>
    </message>
    <message>
        <source>Force against the speed of stretching</source>
        <translation>Kraft gegen die Geschwindigkeit der Dehnung</translation>
    </message>
    <message>
        <source>How the force of the spring is limited</source>
        <translation>Wie die Kraft der Feder begrenzt wird</translation>
    </message>
    <message>
        <source>Most tension, where it is limited</source>
        <translation>Größte Spannung, falls sie begrenzt ist</translation>
    </message>
    <message>
        <source>Share of the limit below which “partial tanh” changes nothing</source>
        <translation>Anteil der Grenze, unter dem „Teilweise Tanh“ nichts ändert</translation>
    </message>
    <message>
        <source>Tags that say what it is</source>
        <translation>Merkmale, die sagen, was es ist</translation>
    </message>
    <message>
        <source>Two bodies meet when each touches a tag that the other has</source>
        <translation>Zwei Körper treffen sich, wenn jeder ein Merkmal berührt, das der andere hat</translation>
    </message>
    <message>
        <source>Of the level, as players see it</source>
        <translation>Des Levels, wie Spieler ihn sehen</translation>
    </message>
    <message>
        <source>Who made it</source>
        <translation>Wer es gemacht hat</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Greatest distance of ship and payload at which the rope can be attached</source>
        <translation>Größter Abstand von Schiff und Fracht, bei dem sich das Seil befestigen lässt</translation>
    </message>
    <message>
        <source>Acceleration of everything that falls</source>
        <translation>Beschleunigung von allem, was fällt</translation>
    </message>
    <message>
        <source>Time that one update simulates</source>
        <translation>Zeit, die ein Zeitschritt simuliert</translation>
    </message>
    <message>
        <source>Passes of motion and collision in one update; more are more exact and slower</source>
        <translation>Durchgänge von Bewegung und Kollision je Zeitschritt; mehr sind genauer und langsamer</translation>
    </message>
    <message>
        <source>Steps of motion in one iteration</source>
        <translation>Bewegungsschritte in einer Iteration</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Schiff</translation>
    </message>
    <message>
        <source>Tow rope</source>
        <translation>Schleppseil</translation>
    </message>
    <message>
        <source>Bodies at rest sleep</source>
        <translation>Ruhende Körper schlafen</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>Force along the nose of the ship</source>
        <translation>Kraft entlang der Nase des Schiffs</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Steuerung</translation>
    </message>
    <message>
        <source>How fast the ship begins to turn while a direction is held</source>
        <translation>Wie schnell das Schiff sich zu drehen beginnt, solange eine Richtung gehalten wird</translation>
    </message>
    <message>
        <source>Of the ship alone</source>
        <translation>Nur des Schiffs, ohne Fracht</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Of the rectangle, along its own side; the middle stays where it is</source>
        <translation>Des Rechtecks, entlang seiner eigenen Seite; die Mitte bleibt, wo sie ist</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>KeyFileTexts</name>
    <message>
        <source>“%1” needs a list of keys, as in [&quot;Ctrl+S&quot;].</source>
        <translation>„%1“ braucht eine Liste von Tasten wie in [&quot;Ctrl+S&quot;].</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no key.</source>
        <translation>„%1“ bei „%2“ ist keine Taste.</translation>
    </message>
    <message>
        <source>%1 is given to “%2” and to “%3”.</source>
        <translation>%1 ist „%2“ und „%3“ zugewiesen.</translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2.</source>
        <translation>Zeile %1 ist kein JSON: %2.</translation>
    </message>
    <message>
        <source>These keys were written by a newer version of the program.</source>
        <translation>Diese Tasten stammen aus einer neueren Version des Programms.</translation>
    </message>
    <message>
        <source>There are no keys in it; it should look like {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</source>
        <translation>Es sind keine Tasten darin; es sollte so aussehen: {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</translation>
    </message>
</context>
<context>
    <name>KeyTexts</name>
    <message>
        <source>That is no single key.</source>
        <translation>Das ist keine einzelne Taste.</translation>
    </message>
    <message>
        <source>%1 belongs to the drawing board and cannot be given away.</source>
        <translation>%1 gehört der Zeichenfläche und lässt sich nicht vergeben.</translation>
    </message>
    <message>
        <source>%1 goes from field to field and cannot be given away.</source>
        <translation>%1 führt von Feld zu Feld und lässt sich nicht vergeben.</translation>
    </message>
    <message>
        <source>“%1” works while a game is running too, when plain keys are the game&apos;s: use Ctrl, Alt or a function key with it.</source>
        <translation>„%1“ wirkt auch während eines Spiels, wo einfache Tasten dem Spiel gehören: Nehmen Sie Strg, Alt oder eine Funktionstaste hinzu.</translation>
    </message>
    <message>
        <source>In the game</source>
        <translation>Im Spiel</translation>
    </message>
    <message>
        <source>%1 cannot be a key of the game: choose one without Ctrl and Alt that is no function key.</source>
        <translation>%1 kann keine Taste des Spiels sein: Wählen Sie eine ohne Strg und Alt, die keine Funktionstaste ist.</translation>
    </message>
    <message>
        <source>%1 always shows the menu of the game.</source>
        <translation>%1 zeigt immer das Menü des Spiels.</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Click · Shift or Ctrl + click</source>
        <translation>Klick · Umschalt oder Strg + Klick</translation>
    </message>
    <message>
        <source>Select · add to the selection or take from it</source>
        <translation>Auswählen · zur Auswahl hinzufügen oder daraus entfernen</translation>
    </message>
    <message>
        <source>Drag on empty space</source>
        <translation>Ziehen auf leerer Fläche</translation>
    </message>
    <message>
        <source>Enter or right click</source>
        <translation>Eingabe oder Rechtsklick</translation>
    </message>
    <message>
        <source>End the shape that is being drawn</source>
        <translation>Die begonnene Form abschließen</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Take back the last point</source>
        <translation>Den letzten Punkt zurücknehmen</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel: gesture, shape, selection, tool</source>
        <translation>Abbrechen: Geste, Form, Auswahl, Werkzeug</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Move the selection a little; Shift: a grid step; Alt: a pixel</source>
        <translation>Die Auswahl ein wenig verschieben; Umschalt: ein Rasterschritt; Alt: ein Pixel</translation>
    </message>
    <message>
        <source>Wheel · pinch</source>
        <translation>Mausrad · Zweifingergeste</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Mauszeiger zoomen</translation>
    </message>
    <message>
        <source>Middle or right drag · Space + drag · two fingers</source>
        <translation>Ziehen mit mittlerer oder rechter Taste · Leertaste + Ziehen · zwei Finger</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Die Ansicht verschieben</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>Hold the game and show the menu</source>
        <translation>Das Spiel anhalten und das Menü zeigen</translation>
    </message>
    <message>
        <source>On the drawing board</source>
        <translation>Auf der Zeichenfläche</translation>
    </message>
    <message>
        <source>Select with a rubber band; Alt or B: only what lies wholly inside</source>
        <translation>Mit einem Rahmen auswählen; Alt oder B: nur was ganz darin liegt</translation>
    </message>
    <message>
        <source>Alt + click · B + click</source>
        <translation>Alt + Klick · B + Klick</translation>
    </message>
    <message>
        <source>Select the next object underneath; a right click lists them all</source>
        <translation>Das nächste Objekt darunter auswählen; ein Rechtsklick listet alle auf</translation>
    </message>
    <message>
        <source>Alt + drag · B + drag</source>
        <translation>Alt + Ziehen · B + Ziehen</translation>
    </message>
    <message>
        <source>Move the selection from anywhere</source>
        <translation>Die Auswahl von überall aus verschieben</translation>
    </message>
    <message>
        <source>Tow the payload when it is near; again: let it go</source>
        <translation>Die Fracht schleppen, wenn sie nah ist; erneut: loslassen</translation>
    </message>
    <message>
        <source>Let the view follow the ship again</source>
        <translation>Die Ansicht wieder dem Schiff folgen lassen</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Nach links drehen</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>Hold the game, or go on</source>
        <translation>Das Spiel anhalten oder fortsetzen</translation>
    </message>
    <message>
        <source>Hold the game and advance it by one update</source>
        <translation>Das Spiel anhalten und um einen Schritt weiterstellen</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Das Level von vorn beginnen</translation>
    </message>
    <message>
        <source>Let time run slower</source>
        <translation>Die Zeit langsamer laufen lassen</translation>
    </message>
    <message>
        <source>Let time run faster</source>
        <translation>Die Zeit schneller laufen lassen</translation>
    </message>
    <message>
        <source>While held: one update back</source>
        <translation>Im angehaltenen Lauf: einen Zeitschritt zurück</translation>
    </message>
    <message>
        <source>While held: one update on</source>
        <translation>Im angehaltenen Lauf: einen Zeitschritt weiter</translation>
    </message>
    <message>
        <source>Turn time back, as long as the key is held</source>
        <translation>Die Zeit zurückdrehen, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>Shift · Ctrl while moving or drawing</source>
        <translation>Umschalt · Strg beim Bewegen oder Zeichnen</translation>
    </message>
    <message>
        <source>Keep to an axis or to steps of 15° · switch snapping off or on for the moment</source>
        <translation>Auf einer Achse oder in 15°-Schritten bleiben · Einrasten vorübergehend aus- oder einschalten</translation>
    </message>
    <message>
        <source>Shift · Ctrl while drawing a rectangle</source>
        <translation>Umschalt · Strg beim Zeichnen eines Rechtecks</translation>
    </message>
    <message>
        <source>From its middle · a square</source>
        <translation>Von der Mitte aus · ein Quadrat</translation>
    </message>
    <message>
        <source>Shift · Ctrl · Alt while scaling</source>
        <translation>Umschalt · Strg · Alt beim Skalieren</translation>
    </message>
    <message>
        <source>About the middle · keep the proportions · switch snapping off or on</source>
        <translation>Um die Mitte · Seitenverhältnis halten · Einrasten aus- oder einschalten</translation>
    </message>
    <message>
        <source>Shift · Ctrl while turning</source>
        <translation>Umschalt · Strg beim Drehen</translation>
    </message>
    <message>
        <source>About the opposite corner · in steps of 15°</source>
        <translation>Um die gegenüberliegende Ecke · in 15°-Schritten</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Bounding box</source>
        <translation>Hüllrechteck</translation>
    </message>
    <message>
        <source>Box of the broad phase, with room to move</source>
        <translation>Rechteck der Grobphase, mit Bewegungsspielraum</translation>
    </message>
    <message>
        <source>Largest circle about the centroid</source>
        <translation>Größter Kreis um den Flächenschwerpunkt</translation>
    </message>
    <message>
        <source>Way of the next second</source>
        <translation>Weg der nächsten Sekunde</translation>
    </message>
    <message>
        <source>Up, 1 m</source>
        <translation>Oben, 1 m</translation>
    </message>
    <message>
        <source>Free side, 1 m</source>
        <translation>Freie Seite, 1 m</translation>
    </message>
    <message>
        <source>Solid band behind the wall</source>
        <translation>Massiver Streifen hinter der Wand</translation>
    </message>
    <message>
        <source>Cell of what stands still</source>
        <translation>Zelle für Ruhendes</translation>
    </message>
    <message>
        <source>Cell of what moves</source>
        <translation>Zelle für Bewegtes</translation>
    </message>
    <message>
        <source>Point of contact</source>
        <translation>Berührungspunkt</translation>
    </message>
    <message>
        <source>Near, not touching yet</source>
        <translation>Nah, noch ohne Berührung</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Pressed to half its length</source>
        <translation>Auf die halbe Länge gedrückt</translation>
    </message>
    <message>
        <source>At its natural length</source>
        <translation>Natürliche Länge</translation>
    </message>
    <message>
        <source>Stretched by half its length</source>
        <translation>Auf das Anderthalbfache gezogen</translation>
    </message>
    <message>
        <source>Way, older ones fainter</source>
        <translation>Weg, älterer blasser</translation>
    </message>
    <message>
        <source>Center of mass and axes</source>
        <translation>Schwerpunkt und Achsen</translation>
    </message>
    <message>
        <source>Name of the object</source>
        <translation>Name des Objekts</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Schläft</translation>
    </message>
    <message>
        <source>Deep enough for what comes</source>
        <translation>Tief genug für das, was kommt</translation>
    </message>
    <message>
        <source>Passed through in one iteration</source>
        <translation>In einer Iteration durchquert</translation>
    </message>
    <message>
        <source>The selection collides with it</source>
        <translation>Die Auswahl kollidiert damit</translation>
    </message>
    <message>
        <source>The selection passes through</source>
        <translation>Die Auswahl geht hindurch</translation>
    </message>
    <message>
        <source>One color an island</source>
        <translation>Eine Farbe je Insel</translation>
    </message>
    <message>
        <source>The color of the first tag; a dot for each further one</source>
        <translation>Die Farbe des ersten Merkmals; ein Punkt für jedes weitere</translation>
    </message>
    <message>
        <source>Force; 1 m is the weight of the lighter one, 2 m ten times as much</source>
        <translation>Kraft; 1 m ist das Gewicht des leichteren, 2 m zehnmal so viel</translation>
    </message>
    <message>
        <source>Way in the time that is kept</source>
        <translation>Weg in der aufbewahrten Zeit</translation>
    </message>
    <message>
        <source>Way in a future given up, dashed</source>
        <translation>Weg in einer aufgegebenen Zukunft, gestrichelt</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>One-way wall</source>
        <translation>Einseitige Kante</translation>
    </message>
    <message>
        <source>Two-way line</source>
        <translation>Zweiseitige Linie</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Schiff</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Fracht</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Ziellinie</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 at %2; %3</source>
        <translation>%1 bei %2; %3</translation>
    </message>
</context>
<context>
    <name>ObjectFilter</name>
    <message>
        <source>wall</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>Polygon</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>Kreis</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statisch</translation>
    </message>
    <message>
        <source>kinematic</source>
        <translation>kinematisch</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamisch</translation>
    </message>
    <message>
        <source>ship</source>
        <translation>Schiff</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>Fracht</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>Ziellinie</translation>
    </message>
    <message>
        <source>connector</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>Ebene</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>&amp;Inspector</source>
        <translation>I&amp;nspektor</translation>
    </message>
    <message>
        <source>&amp;Outliner</source>
        <translation>G&amp;liederung</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Probleme</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Knoten</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Verlauf</translation>
    </message>
    <message>
        <source>&amp;Level Properties</source>
        <translation>Level-&amp;Eigenschaften</translation>
    </message>
    <message>
        <source>&amp;Tag Matrix</source>
        <translation>Merkm&amp;almatrix</translation>
    </message>
    <message>
        <source>Show or hide this panel</source>
        <translation>Zeigt dieses Bedienfeld oder blendet es aus</translation>
    </message>
    <message>
        <source>&amp;Minimap</source>
        <translation>&amp;Minikarte</translation>
    </message>
    <message>
        <source>&amp;Differences</source>
        <translation>Un&amp;terschiede</translation>
    </message>
    <message>
        <source>&amp;Flights</source>
        <translation>&amp;Flüge</translation>
    </message>
    <message>
        <source>&amp;Run Changes</source>
        <translation>Änderungen &amp;im Lauf</translation>
    </message>
    <message>
        <source>E&amp;xplain</source>
        <translation>E&amp;rklärung</translation>
    </message>
    <message>
        <source>Plot&amp;s</source>
        <translation>Dia&amp;gramme</translation>
    </message>
    <message>
        <source>Profil&amp;e</source>
        <translation>Pr&amp;ofil</translation>
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
        <translation>Winkel</translation>
    </message>
    <message>
        <source>velocity to the right</source>
        <translation>Geschwindigkeit nach rechts</translation>
    </message>
    <message>
        <source>velocity upwards</source>
        <translation>Geschwindigkeit nach oben</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>angular velocity</source>
        <translation>Winkelgeschwindigkeit</translation>
    </message>
    <message>
        <source>force to the right</source>
        <translation>Kraft nach rechts</translation>
    </message>
    <message>
        <source>force upwards</source>
        <translation>Kraft nach oben</translation>
    </message>
    <message>
        <source>force of contacts</source>
        <translation>Kraft der Kontakte</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>kinetische Energie</translation>
    </message>
    <message>
        <source>potential energy</source>
        <translation>potenzielle Energie</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>momentum to the right</source>
        <translation>Impuls nach rechts</translation>
    </message>
    <message>
        <source>momentum upwards</source>
        <translation>Impuls nach oben</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>Drehimpuls</translation>
    </message>
    <message>
        <source>length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>elastic energy</source>
        <translation>elastische Energie</translation>
    </message>
    <message>
        <source>energy of everything</source>
        <translation>Energie insgesamt</translation>
    </message>
    <message>
        <source>kinetic energy of everything</source>
        <translation>kinetische Energie insgesamt</translation>
    </message>
    <message>
        <source>potential energy of everything</source>
        <translation>potenzielle Energie insgesamt</translation>
    </message>
    <message>
        <source>elastic energy of everything</source>
        <translation>elastische Energie insgesamt</translation>
    </message>
    <message>
        <source>drift of energy</source>
        <translation>Drift der Energie</translation>
    </message>
    <message>
        <source>momentum of everything to the right</source>
        <translation>Impuls insgesamt nach rechts</translation>
    </message>
    <message>
        <source>momentum of everything upwards</source>
        <translation>Impuls insgesamt nach oben</translation>
    </message>
    <message>
        <source>drift of momentum</source>
        <translation>Drift des Impulses</translation>
    </message>
    <message>
        <source>angular momentum of everything</source>
        <translation>Drehimpuls von allem</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paare</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Time of impact</source>
        <translation>Aufprallzeitpunkt</translation>
    </message>
    <message>
        <source>Crushing</source>
        <translation>Quetschen</translation>
    </message>
    <message>
        <source>Advance</source>
        <translation>Vorrücken</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Berührungen</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>Schlaf</translation>
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
        <translation>Statische Körper</translation>
    </message>
    <message>
        <source>Kinematic bodies</source>
        <translation>Kinematische Körper</translation>
    </message>
    <message>
        <source>Dynamic bodies</source>
        <translation>Dynamische Körper</translation>
    </message>
    <message>
        <source>Awake</source>
        <translation>Wach</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Schläft</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Pairs that may meet</source>
        <translation>Paare, die sich treffen könnten</translation>
    </message>
    <message>
        <source>Pairs that touch</source>
        <translation>Paare, die sich berühren</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Inseln</translation>
    </message>
    <message>
        <source>Leaves of the quadtrees</source>
        <translation>Blätter der Quadtrees</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
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
        <translation>Es gibt schon ein Merkmal mit diesem Namen.</translation>
    </message>
    <message>
        <source>That is how a tag without a name is written.</source>
        <translation>So wird ein Merkmal ohne Namen geschrieben.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.</source>
        <translation>Level zeichnen und fliegen: ein Leveleditor und Physik-Sandkasten.</translation>
    </message>
    <message>
        <source>Level files to open; without any, what was open last.</source>
        <translation>Zu öffnende Leveldateien; ohne Angabe, was zuletzt offen war.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band</source>
        <translation>Klick: auswählen · Ziehen: auswählen und verschieben · Umschalt oder Strg + Klick: hinzufügen oder entfernen · Umschalt + Ziehen: Gummiband</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Verschieben um %1 m, %2 m · Umschalt: entlang einer Achse · Strg: Einrasten aus/ein · Esc: abbrechen</translation>
    </message>
    <message>
        <source>One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what comes from the left of the drawing direction is stopped</source>
        <translation>Einseitige Kante · Klick: erster Punkt · Ziehen: erstes Stück · Strg: Einrasten aus/ein · was von links der Zeichenrichtung kommt, wird aufgehalten</translation>
    </message>
    <message>
        <source>A chain of walls needs two points: click to add another, or Escape to cancel</source>
        <translation>Ein Wandzug braucht zwei Punkte: mit einem Klick einen weiteren setzen oder mit Esc abbrechen</translation>
    </message>
    <message>
        <source>This is where the last point is already: move on before you click</source>
        <translation>Hier liegt schon der letzte Punkt: vor dem Klick weiterbewegen</translation>
    </message>
    <message>
        <source>Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on</source>
        <translation>Zweiseitige Linie · Klick: erster Punkt · Ziehen: erstes Stück · Strg: Einrasten aus/ein</translation>
    </message>
    <message>
        <source>Polygon · click: first corner · drag: first side · Ctrl: snap off/on</source>
        <translation>Polygon · Klick: erste Ecke · Ziehen: erste Seite · Strg: Einrasten aus/ein</translation>
    </message>
    <message>
        <source>A polygon needs three corners: click to add another, or Escape to cancel</source>
        <translation>Ein Polygon braucht drei Ecken: mit einem Klick eine weitere setzen oder mit Esc abbrechen</translation>
    </message>
    <message>
        <source>This is where the last corner is already: move on before you click</source>
        <translation>Hier liegt schon die letzte Ecke: vor dem Klick weiterbewegen</translation>
    </message>
    <message>
        <source>Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on</source>
        <translation>Hier geschlossen würde sich das Polygon selbst kreuzen · Rücktaste: Ecke zurücknehmen · Klick: weiterzeichnen</translation>
    </message>
    <message>
        <source>All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner</source>
        <translation>Alle Ecken liegen auf einer Geraden: ein Polygon braucht ein Inneres · Klick: Ecke hinzufügen · Rücktaste: Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Radius %1 m · Klick oder Loslassen: fertig · Strg: Einrasten aus/ein · Esc: abbrechen</translation>
    </message>
    <message>
        <source>A circle needs a radius: move away from the center before you click</source>
        <translation>Ein Kreis braucht einen Radius: vor dem Klick vom Mittelpunkt wegbewegen</translation>
    </message>
    <message>
        <source>Ship · click: put it here · drag: turn its nose · Ctrl: snap off/on · choose the tool again for the payload</source>
        <translation>Schiff · Klick: hier platzieren · Ziehen: Bug drehen · Strg: Einrasten aus/ein · Werkzeug erneut wählen: Fracht</translation>
    </message>
    <message>
        <source>Nose at %1° · Shift: 15° · release: done · Escape: cancel</source>
        <translation>Bug bei %1° · Umschalt: 15° · Loslassen: fertig · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Payload · click: put it here · drag: move it into place · Ctrl: snap off/on · choose the tool again for the finish</source>
        <translation>Fracht · Klick: hier platzieren · Ziehen: an ihren Platz schieben · Strg: Einrasten aus/ein · Werkzeug erneut wählen: Ziellinie</translation>
    </message>
    <message>
        <source>Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Fracht bei %1 m, %2 m · Strg: Einrasten aus/ein · Loslassen: fertig · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Finish line · click or release at the other end · Shift: 15° · Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel</source>
        <translation>Ziellinie · am anderen Ende klicken oder loslassen · Umschalt: 15° · Strg: Einrasten aus/ein · Länge %1 m, Winkel %2° · Esc: abbrechen</translation>
    </message>
    <message>
        <source>The finish needs two ends: move away from the first before you click</source>
        <translation>Die Ziellinie braucht zwei Enden: vor dem Klick vom ersten wegbewegen</translation>
    </message>
    <message>
        <source>Draw one-way walls</source>
        <translation>Einseitige Kanten zeichnen</translation>
    </message>
    <message>
        <source>Draw two-sided walls</source>
        <translation>Zweiseitige Linien zeichnen</translation>
    </message>
    <message>
        <source>Draw polygon</source>
        <translation>Polygon zeichnen</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>Kreis zeichnen</translation>
    </message>
    <message>
        <source>Place ship</source>
        <translation>Schiff platzieren</translation>
    </message>
    <message>
        <source>Place payload</source>
        <translation>Fracht platzieren</translation>
    </message>
    <message>
        <source>Place finish</source>
        <translation>Ziellinie platzieren</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>Objekt verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>%n Objekt verschieben</numerusform>
            <numerusform>%n Objekte verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate object</source>
        <translation>Objekt drehen</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n objects</source>
        <translation>
            <numerusform>%n Objekt drehen</numerusform>
            <numerusform>%n Objekte drehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reverse object</source>
        <translation>Objekt umkehren</translation>
    </message>
    <message numerus="yes">
        <source>Reverse %n objects</source>
        <translation>
            <numerusform>%n Objekt umkehren</numerusform>
            <numerusform>%n Objekte umkehren</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Objekt löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>%n Objekt löschen</numerusform>
            <numerusform>%n Objekte löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Objekt duplizieren</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n objects</source>
        <translation>
            <numerusform>%n Objekt duplizieren</numerusform>
            <numerusform>%n Objekte duplizieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut object</source>
        <translation>Objekt ausschneiden</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n objects</source>
        <translation>
            <numerusform>%n Objekt ausschneiden</numerusform>
            <numerusform>%n Objekte ausschneiden</numerusform>
        </translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Objekt ändern</translation>
    </message>
    <message numerus="yes">
        <source>Change %n objects</source>
        <translation>
            <numerusform>%n Objekt ändern</numerusform>
            <numerusform>%n Objekte ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>Change level</source>
        <translation>Level ändern</translation>
    </message>
    <message>
        <source>Change tag</source>
        <translation>Merkmal ändern</translation>
    </message>
    <message>
        <source>Paste object</source>
        <translation>Objekt einfügen</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n objects</source>
        <translation>
            <numerusform>%n Objekt einfügen</numerusform>
            <numerusform>%n Objekte einfügen</numerusform>
        </translation>
    </message>
    <message>
        <source>The file “%1” cannot be read: %2.</source>
        <translation>Die Datei „%1“ lässt sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: %2. What was there before is still there.</source>
        <translation>Die Datei „%1“ lässt sich nicht schreiben: %2. Was vorher dort war, ist noch da.</translation>
    </message>
    <message>
        <source>“%1” is not a finite number, and a file cannot hold it.</source>
        <translation>„%1“ ist keine endliche Zahl; eine Datei kann sie nicht enthalten.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must lie between %3 and %4.</source>
        <translation>„%1“ ist %2; der Wert muss zwischen %3 und %4 liegen.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be more than zero.</source>
        <translation>„%1“ ist %2; der Wert muss größer als null sein.</translation>
    </message>
    <message>
        <source>The file starts with a byte order mark, which saving will leave out.</source>
        <translation>Die Datei beginnt mit einer Byte-Reihenfolge-Markierung (BOM), die beim Speichern entfällt.</translation>
    </message>
    <message>
        <source>“%1” is not expected here: something is wrong at this place or just before it.</source>
        <translation>„%1“ wird hier nicht erwartet: An dieser Stelle oder kurz davor stimmt etwas nicht.</translation>
    </message>
    <message>
        <source>A text is not closed with a quotation mark before its line ends.</source>
        <translation>Ein Text wird vor dem Ende seiner Zeile nicht mit einem Anführungszeichen geschlossen.</translation>
    </message>
    <message>
        <source>The control character %1 cannot stand here as it is.</source>
        <translation>Das Steuerzeichen %1 darf hier nicht unverändert stehen.</translation>
    </message>
    <message>
        <source>“%1” is not a number that a file can hold; write a finite one.</source>
        <translation>„%1“ ist keine Zahl, die eine Datei enthalten kann; sie muss endlich sein.</translation>
    </message>
    <message>
        <source>There is a comma before “%1” that nothing follows; leave it out.</source>
        <translation>Vor „%1“ steht ein Komma, auf das nichts folgt; es muss entfallen.</translation>
    </message>
    <message>
        <source>The number %1 is larger than any that can be computed with.</source>
        <translation>Die Zahl %1 ist größer als jede, mit der sich rechnen lässt.</translation>
    </message>
    <message>
        <source>Lists and objects lie more than %1 deep in one another.</source>
        <translation>Listen und Objekte sind mehr als %1-fach ineinander verschachtelt.</translation>
    </message>
    <message>
        <source>The file holds more than %1 values.</source>
        <translation>Die Datei enthält mehr als %1 Werte.</translation>
    </message>
    <message>
        <source>The file holds more than %1 vertices.</source>
        <translation>Die Datei enthält mehr als %1 Eckpunkte.</translation>
    </message>
    <message>
        <source>The field “%1” is given twice.</source>
        <translation>Das Feld „%1“ ist zweimal angegeben.</translation>
    </message>
    <message>
        <source>This is not a level: it should be an object in braces, but is %1.</source>
        <translation>Das ist kein Level: Erwartet wird ein Objekt in geschweiften Klammern, gefunden wurde %1.</translation>
    </message>
    <message>
        <source>This is not a level: the field “schema” is missing (it should be %1).</source>
        <translation>Das ist kein Level: Das Feld „schema“ fehlt (es sollte %1 sein).</translation>
    </message>
    <message>
        <source>The level was made with a newer version (schema %1; this one reads up to %2). Please update the program.</source>
        <translation>Das Level stammt aus einer neueren Version (Schema %1; diese liest bis %2). Bitte aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>The schema %1 is not known; this version reads %2.</source>
        <translation>Das Schema %1 ist unbekannt; diese Version liest %2.</translation>
    </message>
    <message>
        <source>The field “%1” is missing.</source>
        <translation>Das Feld „%1“ fehlt.</translation>
    </message>
    <message>
        <source>The field “%1” is not known here. It is kept, but does nothing.</source>
        <translation>Das Feld „%1“ ist hier unbekannt. Es bleibt erhalten, bewirkt aber nichts.</translation>
    </message>
    <message>
        <source>“%1” must be a number, not %2.</source>
        <translation>„%1“ muss eine Zahl sein, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number, not %2.</source>
        <translation>„%1“ muss eine ganze Zahl sein, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must be a number, or null for a wall without a back, not %2.</source>
        <translation>„%1“ muss eine Zahl sein oder null für eine Wand ohne Rückseite, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must be true or false, not %2.</source>
        <translation>„%1“ muss true oder false sein, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must be a text, not %2.</source>
        <translation>„%1“ muss ein Text sein, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must be two numbers [x, y], not %2.</source>
        <translation>„%1“ muss aus zwei Zahlen [x, y] bestehen, nicht aus %2.</translation>
    </message>
    <message>
        <source>“%1” must be a list in brackets, not %2.</source>
        <translation>„%1“ muss eine Liste in eckigen Klammern sein, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” must hold objects in braces, not %2.</source>
        <translation>„%1“ muss Objekte in geschweiften Klammern enthalten, nicht %2.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be one of: %3.</source>
        <translation>„%1“ ist %2; erlaubt sind: %3.</translation>
    </message>
    <message>
        <source>There is no tag named “%1” in this level.</source>
        <translation>In diesem Level gibt es kein Merkmal namens „%1“.</translation>
    </message>
    <message>
        <source>“%1” must be eight hexadecimal digits that are not all zero, not %2.</source>
        <translation>„%1“ muss aus acht Hexadezimalziffern bestehen, die nicht alle null sind, nicht aus %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by the object in line %2.</source>
        <translation>Der Schlüssel %1 gehört schon dem Objekt in Zeile %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by another object.</source>
        <translation>Der Schlüssel %1 gehört schon einem anderen Objekt.</translation>
    </message>
    <message>
        <source>There are two tags named “%1”.</source>
        <translation>Es gibt zwei Merkmale namens „%1“.</translation>
    </message>
    <message>
        <source>There are two tags with the index %1.</source>
        <translation>Es gibt zwei Merkmale mit dem Index %1.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number from 0 to 31, not %2.</source>
        <translation>„%1“ muss eine ganze Zahl von 0 bis 31 sein, nicht %2.</translation>
    </message>
    <message>
        <source>A tag cannot be named “%1”: that is how a tag without a name is written.</source>
        <translation>Ein Merkmal kann nicht „%1“ heißen: So wird ein Merkmal ohne Namen geschrieben.</translation>
    </message>
    <message>
        <source>“%1” must be a color such as &quot;#4cc9f0&quot;, not %2.</source>
        <translation>„%1“ muss eine Farbe wie &quot;#4cc9f0&quot; sein, nicht %2.</translation>
    </message>
    <message>
        <source>There are %1 more problems, which are not listed.</source>
        <translation>Es gibt %1 weitere Probleme, die nicht aufgeführt sind.</translation>
    </message>
    <message>
        <source>The level has no ship. Place one, or remove payload and finish to make it a sandbox.</source>
        <translation>Das Level hat kein Schiff. Platzieren Sie eines, oder entfernen Sie Fracht und Ziellinie, um einen Sandkasten daraus zu machen.</translation>
    </message>
    <message>
        <source>The level has no payload. Place one, or remove ship and finish to make it a sandbox.</source>
        <translation>Das Level hat keine Fracht. Platzieren Sie eine, oder entfernen Sie Schiff und Ziellinie, um einen Sandkasten daraus zu machen.</translation>
    </message>
    <message>
        <source>The level has no finish. Place one, or remove ship and payload to make it a sandbox.</source>
        <translation>Das Level hat keine Ziellinie. Platzieren Sie eine, oder entfernen Sie Schiff und Fracht, um einen Sandkasten daraus zu machen.</translation>
    </message>
    <message>
        <source>There is more than one ship; only the first flies.</source>
        <translation>Es gibt mehr als ein Schiff; nur das erste fliegt.</translation>
    </message>
    <message>
        <source>There is more than one payload; only the first counts.</source>
        <translation>Es gibt mehr als eine Fracht; nur die erste zählt.</translation>
    </message>
    <message>
        <source>There is more than one finish; only the first counts.</source>
        <translation>Es gibt mehr als eine Ziellinie; nur die erste zählt.</translation>
    </message>
    <message>
        <source>The ship starts in touch with the object “%1” and would crash at once.</source>
        <translation>Das Schiff berührt beim Start das Objekt „%1“ und würde sofort abstürzen.</translation>
    </message>
    <message>
        <source>The payload starts in touch with the object “%1”.</source>
        <translation>Die Fracht berührt beim Start das Objekt „%1“.</translation>
    </message>
    <message>
        <source>The body has no shape.</source>
        <translation>Der Körper hat keine Form.</translation>
    </message>
    <message>
        <source>A chain of walls needs at least two vertices; this one has %1.</source>
        <translation>Ein Wandzug braucht mindestens zwei Eckpunkte; dieser hat %1.</translation>
    </message>
    <message>
        <source>All vertices of this chain of walls lie at the same point.</source>
        <translation>Alle Eckpunkte dieses Wandzugs liegen am selben Punkt.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 lie at the same point: the wall between them has no length.</source>
        <translation>Die Eckpunkte %1 und %2 liegen am selben Punkt: Die Wand dazwischen hat keine Länge.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 of the polygon lie at the same point.</source>
        <translation>Die Eckpunkte %1 und %2 des Polygons liegen am selben Punkt.</translation>
    </message>
    <message>
        <source>A polygon of %1 vertices is too large; %2 are allowed.</source>
        <translation>Ein Polygon mit %1 Eckpunkten ist zu groß; erlaubt sind %2.</translation>
    </message>
    <message>
        <source>A polygon needs at least three different vertices; this one has %1.</source>
        <translation>Ein Polygon braucht mindestens drei verschiedene Eckpunkte; dieses hat %1.</translation>
    </message>
    <message>
        <source>The polygon crosses itself: the sides from vertex %1 and from vertex %2 meet.</source>
        <translation>Das Polygon kreuzt sich selbst: Die Seiten ab Eckpunkt %1 und ab Eckpunkt %2 treffen sich.</translation>
    </message>
    <message>
        <source>The polygon crosses itself.</source>
        <translation>Das Polygon kreuzt sich selbst.</translation>
    </message>
    <message>
        <source>All vertices of the polygon lie on one line: it encloses nothing.</source>
        <translation>Alle Eckpunkte des Polygons liegen auf einer Geraden: Es umschließt nichts.</translation>
    </message>
    <message>
        <source>The vertices of the polygon run clockwise; they are taken the other way round.</source>
        <translation>Die Eckpunkte des Polygons laufen im Uhrzeigersinn; sie werden andersherum gelesen.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which does not exist.</source>
        <translation>Das Ende „%1“ der Verbindung ist das Objekt %2, das es nicht gibt.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which is not a body.</source>
        <translation>Das Ende „%1“ der Verbindung ist das Objekt %2, das kein Körper ist.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same object.</source>
        <translation>Beide Enden der Verbindung sitzen am selben Objekt.</translation>
    </message>
    <message>
        <source>A stiffness of %1 N/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Eine Steifigkeit von %1 N/m ist zu viel für die Teilschritte: Die Feder kann zittern. Etwa %2 Teilschritte würden genügen.</translation>
    </message>
    <message>
        <source>A damping of %1 N s/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Eine Dämpfung von %1 N s/m ist zu viel für die Teilschritte: Die Feder kann zittern. Etwa %2 Teilschritte würden genügen.</translation>
    </message>
    <message>
        <source>The tags of this body are such that nothing can touch it.</source>
        <translation>Die Merkmale dieses Körpers lassen keine Berührung mit anderen zu.</translation>
    </message>
    <message>
        <source>“%1” is not a mass that a body can have.</source>
        <translation>„%1“ ist keine Masse, die ein Körper haben kann.</translation>
    </message>
    <message>
        <source>The body has a shape that cannot be simulated.</source>
        <translation>Die Form des Körpers lässt sich nicht simulieren.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is not in the world.</source>
        <translation>Das Ende „%1“ der Verbindung ist nicht in der Welt.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same body.</source>
        <translation>Beide Enden der Verbindung sitzen am selben Körper.</translation>
    </message>
    <message>
        <source>Nodes · click a wall, line, polygon or finish to edit its nodes</source>
        <translation>Knoten · eine Wand, Linie, ein Polygon oder die Ziellinie anklicken, um die Knoten zu bearbeiten</translation>
    </message>
    <message>
        <source>What is selected has no nodes · click a wall, line, polygon or finish to edit it</source>
        <translation>Das Ausgewählte hat keine Knoten · eine Wand, Linie, ein Polygon oder die Ziellinie anklicken, um es zu bearbeiten</translation>
    </message>
    <message>
        <source>Nodes · click or rubber band: select nodes · Shift + Alt + drag: lasso · double click on a segment: insert a node · Escape: done</source>
        <translation>Knoten · Klick oder Gummiband: Knoten auswählen · Umschalt + Alt + ziehen: Lasso · Doppelklick auf ein Segment: Knoten einfügen · Esc: fertig</translation>
    </message>
    <message>
        <source>Click: edit the nodes of this object · Shift + click: add it to those in edit</source>
        <translation>Klick: Knoten dieses Objekts bearbeiten · Umschalt + Klick: zu den bearbeiteten hinzunehmen</translation>
    </message>
    <message>
        <source>%1 nodes selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Shift+J: join · Shift+R: turn the part between them round as a chain of its own · Escape: select none</source>
        <translation>%1 Knoten ausgewählt · ziehen: verschieben · Pfeiltasten: rücken · Entf: löschen · Umschalt+B: trennen · Umschalt+J: verbinden · Umschalt+R: den Teil dazwischen als eigene Kette umkehren · Esc: keinen auswählen</translation>
    </message>
    <message>
        <source>Node · drag: move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band · Alt while dragging: leave other nodes at this place behind</source>
        <translation>Knoten · ziehen: verschieben · Umschalt oder Strg + Klick: hinzunehmen oder wegnehmen · Umschalt + ziehen: Gummiband · Alt beim Ziehen: andere Knoten an dieser Stelle zurücklassen</translation>
    </message>
    <message>
        <source>Segment · drag: move both ends · click: select them · double click or Ctrl + Alt + click: insert a node here</source>
        <translation>Segment · ziehen: beide Enden verschieben · Klick: sie auswählen · Doppelklick oder Strg + Alt + Klick: hier einen Knoten einfügen</translation>
    </message>
    <message>
        <source>Click: insert a node here</source>
        <translation>Klick: hier einen Knoten einfügen</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m together with other nodes at this place · Alt: leave them behind · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Verschiebung um %1 m, %2 m mit anderen Knoten an dieser Stelle · Alt: sie zurücklassen · Umschalt: entlang einer Achse · Strg: Einrasten aus/an · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Two neighbouring nodes lie on one point, which leaves a side without length · move on, or Escape to cancel</source>
        <translation>Zwei benachbarte Knoten liegen aufeinander, eine Seite hat dann keine Länge · weiterziehen, oder Esc: abbrechen</translation>
    </message>
    <message>
        <source>The polygon crosses itself like this and cannot be played · move on, or Escape to cancel</source>
        <translation>So kreuzt das Polygon sich selbst und lässt sich nicht spielen · weiterziehen, oder Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag: scale the selected nodes · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · click a selected node: turn them instead</source>
        <translation>Ziehen: ausgewählte Knoten skalieren · Umschalt: um die Mitte · Strg: im Verhältnis · Alt: Einrasten aus/an · Klick auf einen ausgewählten Knoten: stattdessen drehen</translation>
    </message>
    <message>
        <source>Drag: turn the selected nodes · Ctrl: in steps of 15° · click a selected node: scale them instead</source>
        <translation>Ziehen: ausgewählte Knoten drehen · Strg: in 15°-Schritten · Klick auf einen ausgewählten Knoten: stattdessen skalieren</translation>
    </message>
    <message>
        <source>Scaling to %1 m × %2 m · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · Escape: cancel</source>
        <translation>Skalierung auf %1 m × %2 m · Umschalt: um die Mitte · Strg: im Verhältnis · Alt: Einrasten aus/an · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Turning by %1° · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Drehung um %1° · Strg: in 15°-Schritten · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Knife · drag a line across walls, lines and polygons to cut them · Shift: 15° · Ctrl: snap off/on</source>
        <translation>Messer · eine Linie über Wände, Linien und Polygone ziehen, um sie zu schneiden · Umschalt: 15° · Strg: Einrasten aus/an</translation>
    </message>
    <message>
        <source>Knife · drag a line across to cut what is selected (%1) · Escape: select nothing, so as to cut everything</source>
        <translation>Messer · eine Linie ziehen, um das Ausgewählte (%1) zu schneiden · Esc: nichts auswählen und damit alles schneiden</translation>
    </message>
    <message>
        <source>Nothing to cut here yet · chains are cut where the line meets them, polygons where it goes right through</source>
        <translation>Hier gibt es noch nichts zu schneiden · Ketten werden geschnitten, wo die Linie sie trifft, Polygone, wo sie ganz hindurchgeht</translation>
    </message>
    <message>
        <source>Click: select the group · double click: enter it · Ctrl + click: select by itself · drag: select and move · Shift + click: add or remove</source>
        <translation>Klick: Gruppe auswählen · Doppelklick: hineingehen · Strg + Klick: einzeln auswählen · ziehen: auswählen und verschieben · Umschalt + Klick: hinzunehmen oder wegnehmen</translation>
    </message>
    <message>
        <source>%1 selected · double click: enter the group · drag: move · click again: turn or scale · Ctrl + click: select by itself · Delete: remove</source>
        <translation>%1 ausgewählt · Doppelklick: in die Gruppe gehen · ziehen: verschieben · erneuter Klick: drehen oder skalieren · Strg + Klick: einzeln auswählen · Entf: löschen</translation>
    </message>
    <message>
        <source>Inside a group, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>In einer Gruppe, %1 ausgewählt · Klicks wählen ihre Mitglieder aus · Esc oder Doppelklick auf freien Grund: verlassen</translation>
    </message>
    <message>
        <source>Inside “%2”, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>In „%2“, %1 ausgewählt · Klicks wählen ihre Mitglieder aus · Esc oder Doppelklick auf freien Grund: verlassen</translation>
    </message>
    <message>
        <source>%1 selected · Ctrl: only what lies wholly inside · Escape: cancel</source>
        <translation>%1 ausgewählt · Strg: nur was ganz darin liegt · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag: turn about the pivot · Shift: about the opposite corner · Ctrl: in steps of 15° · click the object: scale</source>
        <translation>Ziehen: um den Drehpunkt drehen · Umschalt: um die Gegenecke · Strg: in 15°-Schritten · Klick auf das Objekt: skalieren</translation>
    </message>
    <message>
        <source>Turning by %1° · Shift: about the opposite corner · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Drehung um %1° · Umschalt: um die Gegenecke · Strg: in 15°-Schritten · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag: move the pivot, about which the selection turns · Ctrl: snap off/on</source>
        <translation>Ziehen: den Drehpunkt verschieben, um den sich die Auswahl dreht · Strg: Einrasten aus/an</translation>
    </message>
    <message>
        <source>Scale object</source>
        <translation>Objekt skalieren</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n objects</source>
        <translation>
            <numerusform>%n Objekte skalieren</numerusform>
            <numerusform>%n Objekte skalieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip object</source>
        <translation>Objekt spiegeln</translation>
    </message>
    <message numerus="yes">
        <source>Flip %n objects</source>
        <translation>
            <numerusform>%n Objekte spiegeln</numerusform>
            <numerusform>%n Objekte spiegeln</numerusform>
        </translation>
    </message>
    <message>
        <source>Align object</source>
        <translation>Objekt ausrichten</translation>
    </message>
    <message numerus="yes">
        <source>Align %n objects</source>
        <translation>
            <numerusform>%n Objekte ausrichten</numerusform>
            <numerusform>%n Objekte ausrichten</numerusform>
        </translation>
    </message>
    <message>
        <source>Distribute object</source>
        <translation>Objekt verteilen</translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n objects</source>
        <translation>
            <numerusform>%n Objekte verteilen</numerusform>
            <numerusform>%n Objekte verteilen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reorder object</source>
        <translation>Objekt umordnen</translation>
    </message>
    <message numerus="yes">
        <source>Reorder %n objects</source>
        <translation>
            <numerusform>%n Objekte umordnen</numerusform>
            <numerusform>%n Objekte umordnen</numerusform>
        </translation>
    </message>
    <message>
        <source>Group object</source>
        <translation>Objekt gruppieren</translation>
    </message>
    <message numerus="yes">
        <source>Group %n objects</source>
        <translation>
            <numerusform>%n Objekte gruppieren</numerusform>
            <numerusform>%n Objekte gruppieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Gruppierung aufheben</translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n groups</source>
        <translation>
            <numerusform>%n Gruppierungen aufheben</numerusform>
            <numerusform>%n Gruppierungen aufheben</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another layer</source>
        <translation>Objekt in andere Ebene verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another layer</source>
        <translation>
            <numerusform>%n Objekte in andere Ebene verschieben</numerusform>
            <numerusform>%n Objekte in andere Ebene verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Objekt ausblenden</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n objects</source>
        <translation>
            <numerusform>%n Objekte ausblenden</numerusform>
            <numerusform>%n Objekte ausblenden</numerusform>
        </translation>
    </message>
    <message>
        <source>Isolate object</source>
        <translation>Nur das Objekt zeigen</translation>
    </message>
    <message numerus="yes">
        <source>Isolate %n objects</source>
        <translation>
            <numerusform>Nur %n Objekte zeigen</numerusform>
            <numerusform>Nur %n Objekte zeigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Objekt sperren</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n objects</source>
        <translation>
            <numerusform>%n Objekte sperren</numerusform>
            <numerusform>%n Objekte sperren</numerusform>
        </translation>
    </message>
    <message>
        <source>Repeat transform</source>
        <translation>Umformung wiederholen</translation>
    </message>
    <message numerus="yes">
        <source>Repeat transform of %n objects</source>
        <translation>
            <numerusform>Umformung von %n Objekten wiederholen</numerusform>
            <numerusform>Umformung von %n Objekten wiederholen</numerusform>
        </translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Neue Ebene</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Alles entsperren</translation>
    </message>
    <message>
        <source>Array of one copy</source>
        <translation>Anordnung aus einer Kopie</translation>
    </message>
    <message numerus="yes">
        <source>Array of %n copies</source>
        <translation>
            <numerusform>Anordnung aus %n Kopien</numerusform>
            <numerusform>Anordnung aus %n Kopien</numerusform>
        </translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>Körper vereinigen</translation>
    </message>
    <message numerus="yes">
        <source>Unite %n objects</source>
        <translation>
            <numerusform>%n Objekte vereinigen</numerusform>
            <numerusform>%n Objekte vereinigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Subtract bodies</source>
        <translation>Körper abziehen</translation>
    </message>
    <message numerus="yes">
        <source>Subtract %n objects</source>
        <translation>
            <numerusform>%n Objekte abziehen</numerusform>
            <numerusform>%n Objekte abziehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Intersect bodies</source>
        <translation>Körper überschneiden</translation>
    </message>
    <message numerus="yes">
        <source>Intersect %n objects</source>
        <translation>
            <numerusform>%n Objekte überschneiden</numerusform>
            <numerusform>%n Objekte überschneiden</numerusform>
        </translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Knoten verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>%n Knoten verschieben</numerusform>
            <numerusform>%n Knoten verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate nodes</source>
        <translation>Knoten drehen</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n nodes</source>
        <translation>
            <numerusform>%n Knoten drehen</numerusform>
            <numerusform>%n Knoten drehen</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale nodes</source>
        <translation>Knoten skalieren</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n nodes</source>
        <translation>
            <numerusform>%n Knoten skalieren</numerusform>
            <numerusform>%n Knoten skalieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Knoten einfügen</translation>
    </message>
    <message>
        <source>Delete node</source>
        <translation>Knoten löschen</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n nodes</source>
        <translation>
            <numerusform>%n Knoten löschen</numerusform>
            <numerusform>%n Knoten löschen</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Segmente löschen</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Knoten verbinden</translation>
    </message>
    <message>
        <source>Break at node</source>
        <translation>An Knoten trennen</translation>
    </message>
    <message numerus="yes">
        <source>Break at %n nodes</source>
        <translation>
            <numerusform>An %n Knoten trennen</numerusform>
            <numerusform>An %n Knoten trennen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reverse part</source>
        <translation>Teil umkehren</translation>
    </message>
    <message>
        <source>Straighten segments</source>
        <translation>Segmente ausrichten</translation>
    </message>
    <message>
        <source>Cut with the knife</source>
        <translation>Mit dem Messer schneiden</translation>
    </message>
    <message>
        <source>Select at least two bodies made of polygons, not locked.</source>
        <translation>Wählen Sie mindestens zwei nicht gesperrte Körper aus Polygonen aus.</translation>
    </message>
    <message>
        <source>“%1” is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>„%1“ besteht nicht nur aus Polygonen. Nur Polygone lassen sich vereinigen, abziehen und überschneiden.</translation>
    </message>
    <message>
        <source>These bodies lie too far from the origin to be combined: at most 500 km.</source>
        <translation>Diese Körper liegen zu weit vom Ursprung, um verknüpft zu werden: höchstens 500 km.</translation>
    </message>
    <message>
        <source>Nothing would be left of these bodies, so they stay as they are.</source>
        <translation>Von diesen Körpern bliebe nichts übrig, deshalb bleiben sie, wie sie sind.</translation>
    </message>
    <message>
        <source>The result would cross itself, so the bodies stay as they are. Move one of them a little and try again.</source>
        <translation>Das Ergebnis würde sich selbst kreuzen, deshalb bleiben die Körper, wie sie sind. Verschieben Sie einen ein wenig und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>It belongs to the group %1, which does not exist; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Es gehört zur Gruppe %1, die es nicht gibt; es wird ganz oben gezeigt. Legen Sie es in eine andere Gruppe oder nach oben.</translation>
    </message>
    <message>
        <source>It belongs to the object %1, which is not a group; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Es gehört zum Objekt %1, das keine Gruppe ist; es wird ganz oben gezeigt. Legen Sie es in eine andere Gruppe oder nach oben.</translation>
    </message>
    <message>
        <source>It is in the group %1, which is in it, directly or not; it is shown at the top. Put one of them to the top.</source>
        <translation>Es ist in der Gruppe %1, die selbst darin ist, direkt oder nicht; es wird ganz oben gezeigt. Legen Sie eine von beiden nach oben.</translation>
    </message>
    <message>
        <source>A layer is in another group. Layers are at the top: put it there, or make it an ordinary group.</source>
        <translation>Eine Ebene liegt in einer anderen Gruppe. Ebenen sind ganz oben: Legen Sie sie dorthin, oder machen Sie eine gewöhnliche Gruppe daraus.</translation>
    </message>
    <message>
        <source>It is hidden in the editor, but takes part in the game.</source>
        <translation>Es ist im Editor ausgeblendet, nimmt aber am Spiel teil.</translation>
    </message>
    <message>
        <source>Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Punkte: %1 · Klick: hinzufügen · Klick auf den ersten Punkt: schließen · Eingabe oder Rechtsklick: beenden · Rücktaste: Punkt zurücknehmen · Ziffern: Länge und Winkel eingeben · Umschalt: 15° · Strg: Einrasten aus/ein · Länge %2 m, Winkel %3°</translation>
    </message>
    <message>
        <source>Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel</source>
        <translation>Punkte: %1 · Klick: die Kette schließen · Eingabe oder Rechtsklick: offen beenden · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Click or drag: go on with this chain, which keeps its direction · Alt or B + click: begin a chain of its own here</source>
        <translation>Klick oder Ziehen: diese Kette fortsetzen, sie behält ihre Richtung · Alt oder B + Klick: hier eine eigene Kette beginnen</translation>
    </message>
    <message>
        <source>Click: close the chain at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Klick: die Kette an ihrem anderen Ende schließen · Eingabe oder Rechtsklick: offen beenden · Esc: lassen, wie sie war</translation>
    </message>
    <message>
        <source>Click or drag: go on with this line · Alt or B + click: begin a line of its own here</source>
        <translation>Klick oder Ziehen: diese Linie fortsetzen · Alt oder B + Klick: hier eine eigene Linie beginnen</translation>
    </message>
    <message>
        <source>Click: close the line at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Klick: die Linie an ihrem anderen Ende schließen · Eingabe oder Rechtsklick: offen beenden · Esc: lassen, wie sie war</translation>
    </message>
    <message>
        <source>Corners: %1 · click: add · click the first corner, Enter or right click: close · Backspace: undo corner · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Ecken: %1 · Klick: hinzufügen · Klick auf die erste Ecke, Eingabe oder Rechtsklick: schließen · Rücktaste: Ecke zurücknehmen · Ziffern: Länge und Winkel eingeben · Umschalt: 15° · Strg: Einrasten aus/ein · Länge %2 m, Winkel %3°</translation>
    </message>
    <message>
        <source>Corners: %1 · click: close the polygon · Escape: cancel</source>
        <translation>Ecken: %1 · Klick: das Polygon schließen · Esc: abbrechen</translation>
    </message>
    <message>
        <source>This side would run through another one, and a polygon must not cross itself · move on before you click</source>
        <translation>Diese Seite würde eine andere kreuzen, und ein Polygon darf sich nicht selbst kreuzen · vor dem Klick weiterbewegen</translation>
    </message>
    <message>
        <source>The polygon crosses itself where it is marked and cannot be finished like this · Backspace: undo corner</source>
        <translation>Das Polygon kreuzt sich an der markierten Stelle und lässt sich so nicht abschließen · Rücktaste: Ecke zurücknehmen</translation>
    </message>
    <message>
        <source>Rectangle · drag from corner to corner, or click both, or click one and type the size · Shift: from the middle · Ctrl: square</source>
        <translation>Rechteck · von Ecke zu Ecke ziehen oder beide anklicken oder eine anklicken und die Größe eingeben · Umschalt: von der Mitte aus · Strg: Quadrat</translation>
    </message>
    <message>
        <source>Width %1 m, height %2 m · click or release: done · Shift: from the middle · Ctrl: square · Alt or B: snap off/on · Escape: cancel</source>
        <translation>Breite %1 m, Höhe %2 m · Klick oder Loslassen: fertig · Umschalt: von der Mitte aus · Strg: Quadrat · Alt oder B: Einrasten aus/ein · Esc: abbrechen</translation>
    </message>
    <message>
        <source>A rectangle needs width and height: move on before you click or release</source>
        <translation>Ein Rechteck braucht Breite und Höhe: vor dem Klick oder Loslassen weiterbewegen</translation>
    </message>
    <message>
        <source>Moving body · drag: rectangle · click: first corner of a polygon · then its velocity · Shift: from the middle · Ctrl: square</source>
        <translation>Bewegter Körper · Ziehen: Rechteck · Klick: erste Ecke eines Polygons · danach seine Geschwindigkeit · Umschalt: von der Mitte aus · Strg: Quadrat</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · click or drag: set it · digits: type it · Shift: 15° · Ctrl: snap off/on · Enter, right click or Escape: leave the body at rest</source>
        <translation>Geschwindigkeit %1 m/s, %2° · Klick oder Ziehen: festlegen · Ziffern: eingeben · Umschalt: 15° · Strg: Einrasten aus/ein · Eingabe, Rechtsklick oder Esc: den Körper in Ruhe lassen</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · Shift: 15° · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Geschwindigkeit %1 m/s, %2° · Umschalt: 15° · Strg: Einrasten aus/ein · Loslassen: fertig · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Drag: change the velocity of this body, a metre for each m/s</source>
        <translation>Ziehen: die Geschwindigkeit dieses Körpers ändern, ein Meter für jeden m/s</translation>
    </message>
    <message>
        <source>Connector · drag from one body to another, or click both · anchors snap to nodes, middles and the grid</source>
        <translation>Verbindung · von einem Körper zum anderen ziehen oder beide anklicken · Anker rasten an Knoten, Mitten und am Raster ein</translation>
    </message>
    <message>
        <source>Drag or click: connect “%1” with another body</source>
        <translation>Ziehen oder Klick: „%1“ mit einem anderen Körper verbinden</translation>
    </message>
    <message>
        <source>Drag or click: connect this fixed body with another one</source>
        <translation>Ziehen oder Klick: diesen festen Körper mit einem anderen verbinden</translation>
    </message>
    <message>
        <source>Drag or click: connect this moving body with another one</source>
        <translation>Ziehen oder Klick: diesen bewegten Körper mit einem anderen verbinden</translation>
    </message>
    <message>
        <source>Drag or click: connect this loose body with another one</source>
        <translation>Ziehen oder Klick: diesen losen Körper mit einem anderen verbinden</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with “%2” · Escape: cancel</source>
        <translation>Länge %1 m · Loslassen oder Klick: mit „%2“ verbinden · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this fixed body · Escape: cancel</source>
        <translation>Länge %1 m · Loslassen oder Klick: mit diesem festen Körper verbinden · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this moving body · Escape: cancel</source>
        <translation>Länge %1 m · Loslassen oder Klick: mit diesem bewegten Körper verbinden · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this loose body · Escape: cancel</source>
        <translation>Länge %1 m · Loslassen oder Klick: mit diesem losen Körper verbinden · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Neither of these two bodies can be moved by a connector, one should be dynamic · release or click: connect them all the same · length %1 m</source>
        <translation>Keiner dieser beiden Körper lässt sich durch eine Verbindung bewegen, einer sollte dynamisch sein · Loslassen oder Klick: trotzdem verbinden · Länge %1 m</translation>
    </message>
    <message>
        <source>This is the body where the connector begins: it needs another one</source>
        <translation>An diesem Körper beginnt die Verbindung: Sie braucht noch einen anderen</translation>
    </message>
    <message>
        <source>Connectors join bodies; ship, payload and finish are none</source>
        <translation>Verbindungen verbinden Körper; Schiff, Fracht und Ziellinie sind keine</translation>
    </message>
    <message>
        <source>There is no body here: a connector leads from one body to another</source>
        <translation>Hier ist kein Körper: Eine Verbindung führt von einem Körper zu einem anderen</translation>
    </message>
    <message>
        <source>There was no body where the drag began: press on one, then drag to another</source>
        <translation>Wo das Ziehen begann, war kein Körper: auf einen drücken, dann zu einem anderen ziehen</translation>
    </message>
    <message>
        <source>Nothing was connected: release the button over another body</source>
        <translation>Es wurde nichts verbunden: die Taste über einem anderen Körper loslassen</translation>
    </message>
    <message>
        <source>Length and angle · Tab: the other one · an empty one is left to the pointer · Enter or click: place the point · Escape: back to the pointer</source>
        <translation>Länge und Winkel · Tab: das jeweils andere · ein leeres Feld folgt dem Mauszeiger · Eingabe oder Klick: den Punkt setzen · Esc: zurück zum Mauszeiger</translation>
    </message>
    <message>
        <source>Speed and direction · Tab: the other one · an empty one is left to the pointer · Enter or click: set the velocity · Escape: back to the pointer</source>
        <translation>Tempo und Richtung · Tab: das jeweils andere · ein leeres Feld folgt dem Mauszeiger · Eingabe oder Klick: die Geschwindigkeit festlegen · Esc: zurück zum Mauszeiger</translation>
    </message>
    <message>
        <source>Width and height · Tab: the other one · an empty one is left to the pointer · Enter or click: draw the rectangle · Escape: back to the pointer</source>
        <translation>Breite und Höhe · Tab: das jeweils andere · ein leeres Feld folgt dem Mauszeiger · Eingabe oder Klick: das Rechteck zeichnen · Esc: zurück zum Mauszeiger</translation>
    </message>
    <message>
        <source>Radius · Enter or click: draw the circle · Escape: back to the pointer</source>
        <translation>Radius · Eingabe oder Klick: den Kreis zeichnen · Esc: zurück zum Mauszeiger</translation>
    </message>
    <message>
        <source>“%1” is no number in metres: type one such as 2.5, 80 cm or 3/4</source>
        <translation>„%1“ ist keine Zahl in Metern: erwartet wird etwa 2.5, 80 cm oder 3/4</translation>
    </message>
    <message>
        <source>“%1” is no angle: type degrees such as 45, −22.5 or 180/7, anticlockwise from the right</source>
        <translation>„%1“ ist kein Winkel: erwartet werden Grad wie 45, −22.5 oder 180/7, von rechts aus gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>“%1” is too small: a size must be more than nothing</source>
        <translation>„%1“ ist zu klein: Eine Größe muss mehr als nichts sein</translation>
    </message>
    <message>
        <source>Circle · drag from the center, or click it and then click or type the radius · Ctrl: snap off/on</source>
        <translation>Kreis · von der Mitte aus ziehen oder sie anklicken und dann den Radius anklicken oder eingeben · Strg: Einrasten aus/ein</translation>
    </message>
    <message>
        <source>Guide · drag: move it · drag onto a ruler: delete it · double click: type place, angle and name</source>
        <translation>Hilfslinie · Ziehen: verschieben · auf ein Lineal ziehen: löschen · Doppelklick: Ort, Winkel und Namen eingeben</translation>
    </message>
    <message>
        <source>New guide at %1 m, %2 m · release: done · Ctrl: snap off/on · back onto the ruler or Escape: none</source>
        <translation>Neue Hilfslinie bei %1 m, %2 m · Loslassen: fertig · Strg: Einrasten aus/ein · zurück auf das Lineal oder Esc: keine</translation>
    </message>
    <message>
        <source>New guide · drag it into the drawing board · Escape: none</source>
        <translation>Neue Hilfslinie · auf die Zeichenfläche ziehen · Esc: keine</translation>
    </message>
    <message>
        <source>Guide at %1 m, %2 m, %3° · release: done · Shift: turn · Ctrl: snap off/on · onto a ruler: delete · Escape: cancel</source>
        <translation>Hilfslinie bei %1 m, %2 m, %3° · Loslassen: fertig · Umschalt: drehen · Strg: Einrasten aus/ein · auf ein Lineal: löschen · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Guide on the ruler · release: delete it · Escape: cancel</source>
        <translation>Hilfslinie auf dem Lineal · Loslassen: löschen · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Measure · drag from one point to the other, or click both · Ctrl: snap off/on</source>
        <translation>Messen · von einem Punkt zum anderen ziehen oder beide anklicken · Strg: Einrasten aus/ein</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click or release: done · Shift: 15° · Ctrl: snap off/on · Escape: clear</source>
        <translation>%1 m, waagerecht %2 m, senkrecht %3 m, %4° · Klick oder Loslassen: fertig · Umschalt: 15° · Strg: Einrasten aus/ein · Esc: leeren</translation>
    </message>
    <message>
        <source>First point · click the other one · Escape: clear</source>
        <translation>Erster Punkt · den anderen anklicken · Esc: leeren</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, waagerecht %2 m, senkrecht %3 m, %4° · Strg+C: kopieren · Ziehen: neu messen · Esc: leeren</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click: angle %5° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, waagerecht %2 m, senkrecht %3 m, %4° · Klick: Winkel %5° · Strg+C: kopieren · Ziehen: neu messen · Esc: leeren</translation>
    </message>
    <message>
        <source>Angle %1° between %2 m and %3 m · Ctrl+C: copy · click or drag: measure anew · Escape: clear</source>
        <translation>Winkel %1° zwischen %2 m und %3 m · Strg+C: kopieren · Klick oder Ziehen: neu messen · Esc: leeren</translation>
    </message>
    <message>
        <source>Finish line · drag it, or click one end and then click or type the other · Ctrl: snap off/on · choose the tool again for the ship</source>
        <translation>Ziellinie · ziehen oder ein Ende anklicken und dann das andere anklicken oder eingeben · Strg: Einrasten aus/ein · Werkzeug erneut wählen: Schiff</translation>
    </message>
    <message>
        <source>Click: select · drag: rubber band · Shift + Alt (or B) + drag: lasso · Shift or Ctrl + click: add or remove · Alt or B + click: next object underneath</source>
        <translation>Klick: auswählen · Ziehen: Gummiband · Umschalt + Alt (oder B) + Ziehen: Lasso · Umschalt oder Strg + Klick: hinzufügen oder entfernen · Alt oder B + Klick: nächstes Objekt darunter</translation>
    </message>
    <message>
        <source>%1 selected · drag: move · click again: turn or scale · Alt or B + drag: move from anywhere · Shift or Ctrl + click: add or remove · Delete: remove · Escape: select nothing</source>
        <translation>%1 ausgewählt · Ziehen: verschieben · erneuter Klick: drehen oder skalieren · Alt oder B + Ziehen: von überall verschieben · Umschalt oder Strg + Klick: hinzufügen oder entfernen · Entf: löschen · Esc: nichts auswählen</translation>
    </message>
    <message>
        <source>Node · drag: move it alone · Alt or B + drag: move the whole object · double click: edit all nodes</source>
        <translation>Knoten · Ziehen: nur ihn verschieben · Alt oder B + Ziehen: das ganze Objekt verschieben · Doppelklick: alle Knoten bearbeiten</translation>
    </message>
    <message>
        <source>Drag: scale · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on</source>
        <translation>Ziehen: skalieren · Umschalt: um die Mitte · Strg: Seitenverhältnis beibehalten · Alt oder B: Einrasten aus/ein</translation>
    </message>
    <message>
        <source>%1 × %2 m (%3 %, %4 %) · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on · Escape: cancel</source>
        <translation>%1 × %2 m (%3 %, %4 %) · Umschalt: um die Mitte · Strg: Seitenverhältnis beibehalten · Alt oder B: Einrasten aus/ein · Esc: abbrechen</translation>
    </message>
    <message>
        <source>%1 selected · Alt or B: only what lies wholly inside · Escape: cancel</source>
        <translation>%1 ausgewählt · Alt oder B: nur was ganz darin liegt · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>Rechteck zeichnen</translation>
    </message>
    <message>
        <source>Draw moving body</source>
        <translation>Bewegten Körper zeichnen</translation>
    </message>
    <message>
        <source>Draw connector</source>
        <translation>Verbindung zeichnen</translation>
    </message>
    <message>
        <source>Set velocity</source>
        <translation>Geschwindigkeit festlegen</translation>
    </message>
    <message>
        <source>Extend chain</source>
        <translation>Kette verlängern</translation>
    </message>
    <message>
        <source>Move object to another group</source>
        <translation>Objekt in andere Gruppe verschieben</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another group</source>
        <translation>
            <numerusform>%n Objekt in andere Gruppe verschieben</numerusform>
            <numerusform>%n Objekte in andere Gruppe verschieben</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename object</source>
        <translation>Objekt umbenennen</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Objekt anzeigen</translation>
    </message>
    <message numerus="yes">
        <source>Show %n objects</source>
        <translation>
            <numerusform>%n Objekt anzeigen</numerusform>
            <numerusform>%n Objekte anzeigen</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Objekt entsperren</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n objects</source>
        <translation>
            <numerusform>%n Objekt entsperren</numerusform>
            <numerusform>%n Objekte entsperren</numerusform>
        </translation>
    </message>
    <message>
        <source>Change who touches whom</source>
        <translation>Ändern, wer wen berührt</translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>Hilfslinie hinzufügen</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>Hilfslinie ändern</translation>
    </message>
    <message>
        <source>Delete guide</source>
        <translation>Hilfslinie löschen</translation>
    </message>
    <message>
        <source>Delete all guides</source>
        <translation>Alle Hilfslinien löschen</translation>
    </message>
    <message>
        <source>“%1” must be “all”, a list of tags or {&quot;except&quot;: a list of tags}, not %2.</source>
        <translation>„%1“ muss „all“, eine Liste von Merkmalen oder {&quot;except&quot;: eine Liste von Merkmalen} sein, nicht %2.</translation>
    </message>
    <message>
        <source>The ship starts in touch with %2 at %3; %4 m and would crash at once.</source>
        <translation>Beim Start berühren sich das Schiff und %2 bei %3; %4 m, und das Schiff würde sofort zerschellen.</translation>
    </message>
    <message>
        <source>The payload starts in touch with %2 at %3; %4 m.</source>
        <translation>Beim Start berühren sich die Fracht und %2 bei %3; %4 m.</translation>
    </message>
    <message>
        <source>the one-way wall</source>
        <translation>die einseitige Kante</translation>
    </message>
    <message>
        <source>the two-way line</source>
        <translation>die zweiseitige Linie</translation>
    </message>
    <message>
        <source>the polygon</source>
        <translation>das Polygon</translation>
    </message>
    <message>
        <source>the circle</source>
        <translation>der Kreis</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>der Körper</translation>
    </message>
    <message>
        <source>These tags came along, as the level did not have them: %1.</source>
        <translation>Diese Merkmale sind hinzugekommen, weil das Level sie nicht hatte: %1.</translation>
    </message>
    <message>
        <source>The tag “%1” is called “%2” in this level.</source>
        <translation>Das Merkmal „%1“ heißt in diesem Level „%2“.</translation>
    </message>
    <message>
        <source>All 32 tags of this level are in use, so these were left off: %1.</source>
        <translation>Alle 32 Merkmale dieses Levels sind in Gebrauch, deshalb wurden diese weggelassen: %1.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Eine Zahl fehlt.</translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation>Am Ende fehlt etwas.</translation>
    </message>
    <message>
        <source>“%1” cannot stand where it is.</source>
        <translation>„%1“ kann an dieser Stelle nicht stehen.</translation>
    </message>
    <message>
        <source>“%1” is neither a unit nor a function; try 2*pi/3, sqrt(2), 20 cm or +=0.5.</source>
        <translation>„%1“ ist weder eine Einheit noch eine Funktion; möglich ist etwa 2*pi/3, sqrt(2), 20 cm oder +=0.5.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Eine Klammer ist nicht geschlossen.</translation>
    </message>
    <message>
        <source>“%1” has another number of values; they are parted by semicolons.</source>
        <translation>„%1“ hat eine andere Anzahl von Werten; sie werden durch Semikolons getrennt.</translation>
    </message>
    <message>
        <source>This is too long or too deeply nested.</source>
        <translation>Das ist zu lang oder zu tief verschachtelt.</translation>
    </message>
    <message>
        <source>Nothing can be divided by zero.</source>
        <translation>Durch null lässt sich nicht teilen.</translation>
    </message>
    <message>
        <source>The result is too large, or is no number.</source>
        <translation>Das Ergebnis ist zu groß oder keine Zahl.</translation>
    </message>
    <message>
        <source>These units do not go together.</source>
        <translation>Diese Einheiten passen nicht zusammen.</translation>
    </message>
    <message>
        <source>The result must be a plain number or one in %1.</source>
        <translation>Das Ergebnis muss eine bloße Zahl oder eine in %1 sein.</translation>
    </message>
    <message>
        <source>This is a plain number without a unit.</source>
        <translation>Das ist eine bloße Zahl ohne Einheit.</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>Eckpunkt</translation>
    </message>
    <message>
        <source>vertex of %1</source>
        <translation>Eckpunkt von %1</translation>
    </message>
    <message>
        <source>center</source>
        <translation>Mittelpunkt</translation>
    </message>
    <message>
        <source>center of %1</source>
        <translation>Mittelpunkt von %1</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>Schnittpunkt</translation>
    </message>
    <message>
        <source>intersection with %1</source>
        <translation>Schnittpunkt mit %1</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>midpoint of %1</source>
        <translation>Mitte von %1</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>senkrecht</translation>
    </message>
    <message>
        <source>perpendicular to %1</source>
        <translation>senkrecht zu %1</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>edge of %1</source>
        <translation>Kante von %1</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>Hilfslinie</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>Hilfslinie %1</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>ausgerichtet</translation>
    </message>
    <message>
        <source>in line with %1</source>
        <translation>in einer Linie mit %1</translation>
    </message>
    <message>
        <source>multiple of 15°</source>
        <translation>Vielfaches von 15°</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>The file declares entities of its own (line %1), which are not read because they can be made to grow without end. Save it as plain SVG, for example with Inkscape, and try again.</source>
        <translation>Die Datei deklariert eigene Entitäten (Zeile %1). Sie werden nicht gelesen, weil sie sich endlos aufblähen lassen. Speichern Sie die Datei als einfaches SVG, etwa mit Inkscape, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The import was stopped; nothing was changed.</source>
        <translation>Der Import wurde angehalten; es hat sich nichts geändert.</translation>
    </message>
    <message>
        <source>The file is compressed. Unpack it first, or save it as plain SVG instead of SVGZ.</source>
        <translation>Die Datei ist komprimiert. Entpacken Sie sie zuerst, oder speichern Sie sie als einfaches SVG statt SVGZ.</translation>
    </message>
    <message>
        <source>This is no file that can be imported: SVG drawings, maps of Tiled (.tmx, .tmj) and scenes of R.U.B.E. (.json) can.</source>
        <translation>Diese Datei lässt sich nicht importieren; es gehen SVG-Zeichnungen, Karten von Tiled (.tmx, .tmj) und Szenen von R.U.B.E. (.json).</translation>
    </message>
    <message>
        <source>This is a level already: open it instead of importing it.</source>
        <translation>Das ist schon ein Level: öffnen statt importieren.</translation>
    </message>
    <message>
        <source>This is a tileset or a template of Tiled, which draws nothing. Import a map.</source>
        <translation>Das ist ein Kachelsatz oder eine Vorlage von Tiled und zeichnet nichts. Importieren Sie eine Karte.</translation>
    </message>
    <message>
        <source>At this scale something would lie more than %1 m away. Choose a smaller scale.</source>
        <translation>In diesem Maßstab läge etwas mehr als %1 m entfernt. Wählen Sie einen kleineren Maßstab.</translation>
    </message>
    <message>
        <source>The result would have more than %1 vertices. Choose a larger tolerance.</source>
        <translation>Das Ergebnis hätte mehr als %1 Eckpunkte. Wählen Sie eine größere Toleranz.</translation>
    </message>
    <message>
        <source>There is nothing in this file that could become part of a level.</source>
        <translation>Diese Datei enthält nichts, was Teil eines Levels werden könnte.</translation>
    </message>
    <message>
        <source>Text was left out (%4). Turn it into paths to have it.</source>
        <translation>Text wurde weggelassen (%4). In Pfade umgewandelt kommt er mit.</translation>
    </message>
    <message>
        <source>Pictures were left out (%4).</source>
        <translation>Bilder wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Content in another language than SVG was left out (%4).</source>
        <translation>Inhalt in einer anderen Sprache als SVG wurde weggelassen (%4).</translation>
    </message>
    <message>
        <source>Animations were left out (%4).</source>
        <translation>Animationen wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Scripts were left out (%4).</source>
        <translation>Skripte wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Some selectors of a style sheet are not understood (%4): what they say of fill and stroke was not taken over.</source>
        <translation>Einige Selektoren einer Formatvorlage sind unverständlich (%4): Was sie über Füllung und Kontur sagen, wurde nicht übernommen.</translation>
    </message>
    <message>
        <source>What is not displayed was left out (%4).</source>
        <translation>Was nicht angezeigt wird, wurde weggelassen (%4).</translation>
    </message>
    <message>
        <source>Shapes without fill and stroke were left out (%4).</source>
        <translation>Formen ohne Füllung und Kontur wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>A transform is not understood and was left out (%4).</source>
        <translation>Eine Umformung ist unverständlich und wurde weggelassen (%4).</translation>
    </message>
    <message>
        <source>Clips and masks were not applied: shapes are there as a whole (%4).</source>
        <translation>Ausschnitte und Masken wurden nicht angewendet: Die Formen sind ganz da (%4).</translation>
    </message>
    <message>
        <source>Filters were not applied (%4).</source>
        <translation>Filter wurden nicht angewendet (%4).</translation>
    </message>
    <message>
        <source>References to what is not in the file, or to themselves, were left out (%4): %3</source>
        <translation>Verweise auf sich selbst oder auf etwas, das nicht in der Datei ist, wurden weggelassen (%4): %3</translation>
    </message>
    <message>
        <source>The data of shapes has a mistake; they are there up to it (%4).</source>
        <translation>Die Daten von Formen haben einen Fehler; bis dorthin sind sie da (%4).</translation>
    </message>
    <message>
        <source>Shapes without any extent were left out (%4).</source>
        <translation>Formen ohne Ausdehnung wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Areas with holes, or in several parts, were cut into several polygons (%4).</source>
        <translation>Flächen mit Löchern oder aus mehreren Teilen wurden in mehrere Polygone zerlegt (%4).</translation>
    </message>
    <message>
        <source>Polygons of more than 1024 vertices became walls (%4). A larger tolerance makes fewer vertices.</source>
        <translation>Polygone mit mehr als 1024 Eckpunkten wurden zu Wänden (%4). Eine größere Toleranz ergibt weniger Eckpunkte.</translation>
    </message>
    <message>
        <source>Areas that cross themselves very often became walls (%4).</source>
        <translation>Flächen, die sich sehr oft selbst kreuzen, wurden zu Wänden (%4).</translation>
    </message>
    <message>
        <source>Layers of tiles were left out, for a level has no tiles: %3 (%4). Objects of object layers are taken over.</source>
        <translation>Kachelebenen wurden weggelassen, denn ein Level hat keine Kacheln: %3 (%4). Objekte aus Objektebenen werden übernommen.</translation>
    </message>
    <message>
        <source>Layers of pictures were left out: %3 (%4).</source>
        <translation>Bildebenen wurden weggelassen: %3 (%4).</translation>
    </message>
    <message>
        <source>Tilesets are not needed and were not read: %3.</source>
        <translation>Kachelsätze sind nicht nötig und wurden nicht gelesen: %3.</translation>
    </message>
    <message>
        <source>Objects that are tiles were left out (%4).</source>
        <translation>Objekte, die Kacheln sind, wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Objects made of templates were left out, for these are in other files (%4). Detach them in Tiled.</source>
        <translation>Objekte aus Vorlagen wurden weggelassen, denn diese stehen in anderen Dateien (%4). Lösen Sie sie in Tiled ab.</translation>
    </message>
    <message>
        <source>Objects of a form that is not known here were left out (%4).</source>
        <translation>Objekte von hier unbekannter Form wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Points were left out (%4): only those of the class “ship” or “payload” become something.</source>
        <translation>Punkte wurden weggelassen (%4): Nur aus denen der Klasse „ship“ oder „payload“ wird etwas.</translation>
    </message>
    <message>
        <source>Properties that mean nothing here were left out (%4): %3.</source>
        <translation>Eigenschaften, die hier nichts bedeuten, wurden weggelassen (%4): %3.</translation>
    </message>
    <message>
        <source>The opacity of layers was not taken over: %3 (%4).</source>
        <translation>Die Deckkraft von Ebenen wurde nicht übernommen: %3 (%4).</translation>
    </message>
    <message>
        <source>The parallax of layers was not taken over: %3 (%4).</source>
        <translation>Die Parallaxe von Ebenen wurde nicht übernommen: %3 (%4).</translation>
    </message>
    <message>
        <source>Gravity was not taken over (%4): the level keeps its own.</source>
        <translation>Die Schwerkraft wurde nicht übernommen (%4): Das Level behält seine eigene.</translation>
    </message>
    <message>
        <source>Numbers that a level cannot have were brought into its range (%4): %3.</source>
        <translation>Zahlen, die ein Level nicht haben kann, wurden in seinen Bereich gebracht (%4): %3.</translation>
    </message>
    <message>
        <source>Fixtures without a sound shape were left out (%4).</source>
        <translation>Fixtures ohne gültige Form wurden weggelassen (%4).</translation>
    </message>
    <message>
        <source>Group indices of filters were not taken over (%4): %3</source>
        <translation>Gruppenindizes von Filtern wurden nicht übernommen (%4): %3</translation>
    </message>
    <message>
        <source>Fixtures of one body differ in material or filter: those of the first were taken (%4): %3</source>
        <translation>Fixtures eines Körpers haben verschiedene Materialien oder Filter: Übernommen wurden die der ersten (%4): %3</translation>
    </message>
    <message>
        <source>Sensors of bodies that also have solid fixtures were left out (%4): %3</source>
        <translation>Sensoren von Körpern, die auch feste Fixtures haben, wurden weggelassen (%4): %3</translation>
    </message>
    <message>
        <source>Settings of bodies that mean nothing here were left out (%4): %3</source>
        <translation>Einstellungen von Körpern, die hier nichts bedeuten, wurden weggelassen (%4): %3</translation>
    </message>
    <message>
        <source>Bodies without fixtures were left out (%4): %3</source>
        <translation>Körper ohne Fixtures wurden weggelassen (%4): %3</translation>
    </message>
    <message>
        <source>Joints that no connector can be were left out (%4): %3</source>
        <translation>Gelenke, aus denen keine Verbindung werden kann, wurden weggelassen (%4): %3</translation>
    </message>
    <message>
        <source>Rigid joints became stiff connectors (%4): %3</source>
        <translation>Starre Gelenke wurden zu steifen Verbindungen (%4): %3</translation>
    </message>
    <message>
        <source>The level has a ship, a payload or a finish already; those of the file were left out.</source>
        <translation>Das Level hat schon ein Schiff, eine Fracht oder eine Ziellinie; die der Datei wurden weggelassen.</translation>
    </message>
    <message>
        <source>All 32 tags are taken; these were left out: %3</source>
        <translation>Alle 32 Merkmale sind vergeben; diese wurden weggelassen: %3</translation>
    </message>
    <message>
        <source>Reopen level</source>
        <translation>Level wieder öffnen</translation>
    </message>
    <message>
        <source>Remove points on straight sides</source>
        <translation>Punkte auf geraden Seiten entfernen</translation>
    </message>
    <message>
        <source>Merge points</source>
        <translation>Punkte verschmelzen</translation>
    </message>
    <message>
        <source>Turn outline round</source>
        <translation>Umriss umkehren</translation>
    </message>
    <message>
        <source>Reverse wall</source>
        <translation>Wand umkehren</translation>
    </message>
    <message>
        <source>Close gap</source>
        <translation>Lücke schließen</translation>
    </message>
    <message>
        <source>Add the missing wall</source>
        <translation>Fehlende Wand ergänzen</translation>
    </message>
    <message>
        <source>Remove what is there twice</source>
        <translation>Doppeltes entfernen</translation>
    </message>
    <message>
        <source>Limit depth</source>
        <translation>Tiefe begrenzen</translation>
    </message>
    <message>
        <source>Choose plain background</source>
        <translation>Einfarbigen Hintergrund wählen</translation>
    </message>
    <message>
        <source>Move out of group</source>
        <translation>Aus der Gruppe nehmen</translation>
    </message>
    <message>
        <source>Give a new key</source>
        <translation>Neuen Schlüssel geben</translation>
    </message>
    <message>
        <source>Tag as wall</source>
        <translation>Wand-Merkmal geben</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove broken shapes</source>
        <translation>Defekte Formen entfernen</translation>
    </message>
    <message>
        <source>Untangle outline</source>
        <translation>Umriss entwirren</translation>
    </message>
    <message>
        <source>Move to a free place</source>
        <translation>An freien Ort verschieben</translation>
    </message>
    <message>
        <source>Fix all safe problems</source>
        <translation>Alles sicher Behebbare beheben</translation>
    </message>
    <message>
        <source>Hide problem</source>
        <translation>Problem ausblenden</translation>
    </message>
    <message>
        <source>Show hidden problem</source>
        <translation>Problem wieder zeigen</translation>
    </message>
    <message>
        <source>Take over object</source>
        <translation>Objekt übernehmen</translation>
    </message>
    <message numerus="yes">
        <source>Take over %n objects</source>
        <translation>
            <numerusform>%n Objekt übernehmen</numerusform>
            <numerusform>%n Objekte übernehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Aus Datei neu laden</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Ungespeichertes retten</translation>
    </message>
    <message>
        <source>Open backup</source>
        <translation>Sicherung öffnen</translation>
    </message>
    <message>
        <source>Import object</source>
        <translation>Objekt importieren</translation>
    </message>
    <message numerus="yes">
        <source>Import %n objects</source>
        <translation>
            <numerusform>%n Objekt importieren</numerusform>
            <numerusform>%n Objekte importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>The disk is full, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>Der Datenträger ist voll, deshalb lässt sich die Datei „%1“ nicht schreiben. Was vorher dort war, ist noch da.</translation>
    </message>
    <message>
        <source>You have used up your share of the disk, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>Ihr Anteil am Datenträger ist aufgebraucht, deshalb lässt sich die Datei „%1“ nicht schreiben. Was vorher dort war, ist noch da.</translation>
    </message>
    <message>
        <source>The disk with the file “%1” can only be read, so it cannot be written.</source>
        <translation>Der Datenträger mit der Datei „%1“ lässt sich nur lesen, deshalb kann sie nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: there is no folder “%2” any more.</source>
        <translation>Die Datei „%1“ lässt sich nicht schreiben: Den Ordner „%2“ gibt es nicht mehr.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: you may not make files in the folder “%2”.</source>
        <translation>Die Datei „%1“ lässt sich nicht schreiben: Im Ordner „%2“ dürfen Sie keine Dateien anlegen.</translation>
    </message>
    <message>
        <source>The file “%1” is protected: you may read it, but not write it.</source>
        <translation>Die Datei „%1“ ist geschützt: Sie dürfen sie lesen, aber nicht schreiben.</translation>
    </message>
    <message>
        <source>The file “%1” has been changed by somebody else meanwhile, so it was not overwritten.</source>
        <translation>Die Datei „%1“ wurde inzwischen von jemand anderem geändert und deshalb nicht überschrieben.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. What was there before is lost; save it elsewhere.</source>
        <translation>Die Datei „%1“ wurde nur zum Teil geschrieben: %2. Was vorher dort war, ist verloren; speichern Sie an anderer Stelle.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. All that it was to hold is in the file “%3”.</source>
        <translation>Die Datei „%1“ wurde nur zum Teil geschrieben: %2. Alles, was sie enthalten sollte, steht in der Datei „%3“.</translation>
    </message>
    <message>
        <source>The mass is too small or too large to be computed with, so the body would be missing from the game.</source>
        <translation>Die Masse ist zu klein oder zu groß, um damit zu rechnen; der Körper würde im Spiel fehlen.</translation>
    </message>
    <message>
        <source>The body is so small and light, or so large and heavy, that its mass or inertia cannot be computed with. It would be missing from the game.</source>
        <translation>Der Körper ist so klein und leicht oder so groß und schwer, dass sich mit seiner Masse oder Trägheit nicht rechnen lässt. Er würde im Spiel fehlen.</translation>
    </message>
    <message>
        <source>The level is so large that it could not be saved again, so it is not opened.</source>
        <translation>Das Level ist so groß, dass es sich nicht wieder speichern ließe; deshalb wird es nicht geöffnet.</translation>
    </message>
    <message>
        <source>Points that lie on straight sides and do nothing: %1.</source>
        <translation>Punkte, die auf geraden Seiten liegen und nichts bewirken: %1.</translation>
    </message>
    <message>
        <source>This wall is solid on the other side than the walls it goes on from: the ship can fly out through it. Reverse it.</source>
        <translation>Diese Wand ist auf der anderen Seite fest als die Wände, die sie fortsetzt: Das Schiff kann hindurch ins Freie fliegen. Kehren Sie sie um.</translation>
    </message>
    <message>
        <source>This wall and the one it goes on from are solid on different sides. Reverse one of them.</source>
        <translation>Diese Wand und die, die sie fortsetzt, sind auf verschiedenen Seiten fest. Kehren Sie eine von beiden um.</translation>
    </message>
    <message>
        <source>The two ends of this chain of walls are %1 mm apart, so it is not closed.</source>
        <translation>Die beiden Enden dieses Wandzugs liegen %1 mm auseinander, er ist also nicht geschlossen.</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to “%1”.</source>
        <translation>Zu „%1“ klafft eine Lücke von %5 mm.</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to %2 at %3; %4 m.</source>
        <translation>Eine Lücke von %5 mm klafft bis hier: %2 bei %3; %4 m.</translation>
    </message>
    <message>
        <source>This wall lies exactly on “%1”, which does the same.</source>
        <translation>Diese Wand liegt genau auf „%1“ und bewirkt dasselbe.</translation>
    </message>
    <message>
        <source>This wall lies exactly on %2 at %3; %4 m, which does the same.</source>
        <translation>Diese Wand und %2 bei %3; %4 m liegen genau aufeinander und bewirken dasselbe.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of “%1”: %5.</source>
        <translation>Wände, die genau auf denen von „%1“ liegen: %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of %2 at %3; %4 m: %5.</source>
        <translation>Wände, die genau auf anderen liegen (%2 bei %3; %4 m): %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on others of the same chain: %1.</source>
        <translation>Wände, die genau auf anderen desselben Wandzugs liegen: %1.</translation>
    </message>
    <message>
        <source>It lies exactly on “%1”, which is the same.</source>
        <translation>Es liegt genau auf „%1“, das dasselbe ist.</translation>
    </message>
    <message>
        <source>It lies exactly on %2 at %3; %4 m, which is the same.</source>
        <translation>Es liegt genau auf einem gleichen Objekt: %2 bei %3; %4 m.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but what is fastest here may move %2 m between two looks at what it touches, and may get through. Make it deeper, or raise the iterations.</source>
        <translation>Die Wand ist %1 m tief, aber das Schnellste hier kann sich zwischen zwei Prüfungen auf Berührung %2 m bewegen und so hindurchgelangen. Machen Sie sie tiefer, oder erhöhen Sie die Iterationen.</translation>
    </message>
    <message>
        <source>The wall has no back, so what is solid behind it reaches into the free space %1 m behind. Give it a depth of no more than that.</source>
        <translation>Die Wand hat keine Rückseite, deshalb reicht das Feste hinter ihr bis in den freien Raum %1 m dahinter. Geben Sie ihr höchstens diese Tiefe.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but %2 m behind it there is free space, into which it reaches. Give it a depth of no more than that.</source>
        <translation>Die Wand ist %1 m tief, aber %2 m hinter ihr ist freier Raum, in den sie hineinreicht. Geben Sie ihr höchstens diese Tiefe.</translation>
    </message>
    <message>
        <source>The wall has no back, so all the free space behind it counts as solid. Give it a depth.</source>
        <translation>Die Wand hat keine Rückseite, deshalb gilt aller freie Raum hinter ihr als fest. Geben Sie ihr eine Tiefe.</translation>
    </message>
    <message>
        <source>The ship starts outside of the cave that the payload is in.</source>
        <translation>Das Schiff startet außerhalb der Höhle, in der die Fracht ist.</translation>
    </message>
    <message>
        <source>The payload is outside of the cave that the ship starts in.</source>
        <translation>Die Fracht ist außerhalb der Höhle, in der das Schiff startet.</translation>
    </message>
    <message>
        <source>The finish is outside of the cave that the ship starts in.</source>
        <translation>Die Ziellinie ist außerhalb der Höhle, in der das Schiff startet.</translation>
    </message>
    <message>
        <source>Both ends of the finish lie at the same point, so nothing can cross it.</source>
        <translation>Beide Enden der Ziellinie liegen am selben Punkt, nichts kann sie also überqueren.</translation>
    </message>
    <message>
        <source>The payload starts on the finish.</source>
        <translation>Die Fracht startet auf der Ziellinie.</translation>
    </message>
    <message>
        <source>Gravity is too strong: the ship weighs %1 N, and its thrust is %2 N.</source>
        <translation>Die Schwerkraft ist zu stark: Das Schiff wiegt %1 N, und sein Schub beträgt %2 N.</translation>
    </message>
    <message>
        <source>Ship and payload together weigh %1 N; the ship&apos;s thrust of %2 N cannot lift them.</source>
        <translation>Schiff und Fracht wiegen zusammen %1 N; der Schub des Schiffs von %2 N kann sie nicht heben.</translation>
    </message>
    <message>
        <source>There is no background named “%1”; it is shown as a plain one.</source>
        <translation>Es gibt keinen Hintergrund namens „%1“; er wird einfarbig gezeigt.</translation>
    </message>
    <message>
        <source>The ship flies through this wall: it does not have the tag “%1”.</source>
        <translation>Das Schiff fliegt durch diese Wand hindurch: Sie hat das Merkmal „%1“ nicht.</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through “%1”.</source>
        <translation>Es besteht nur aus Wänden, und Wände treffen nie auf Wände: Es fällt durch „%1“ hindurch.</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through %2 at %3; %4 m.</source>
        <translation>Es besteht nur aus Wänden, und Wände treffen nie auf Wände: Es fällt hindurch (%2 bei %3; %4 m).</translation>
    </message>
    <message>
        <source>The ship can get out through this wall: it is solid on the wrong side. Reverse it.</source>
        <translation>Durch diese Wand kommt das Schiff hinaus: Sie ist auf der falschen Seite fest. Kehren Sie sie um.</translation>
    </message>
    <message>
        <source>The ship can get out through this chain: all its %1 walls are solid on the wrong side. Reverse it.</source>
        <translation>Durch diese Kette kommt das Schiff hinaus: Alle ihre %1 Wände sind auf der falschen Seite fest. Kehren Sie sie um.</translation>
    </message>
    <message>
        <source>The ship can get out through edge %1 of this chain: it is solid on the wrong side.</source>
        <translation>Durch Kante %1 dieser Kette kommt das Schiff hinaus: Sie ist auf der falschen Seite fest.</translation>
    </message>
    <message>
        <source>The ship can get out: %1 walls, of which this is one, are solid on the wrong side.</source>
        <translation>Das Schiff kommt hinaus: %1 Wände, darunter diese, sind auf der falschen Seite fest.</translation>
    </message>
    <message>
        <source>The ship can get out: this chain is not closed, its ends are %1 m apart.</source>
        <translation>Das Schiff kommt hinaus: Diese Kette ist nicht geschlossen, ihre Enden sind %1 m voneinander entfernt.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %1 m is missing between two ends of this object.</source>
        <translation>Das Schiff kommt hinaus: Zwischen zwei Enden dieses Objekts fehlt eine Wand von %1 m.</translation>
    </message>
    <message>
        <source>The ship can get out: there is an opening of %1 m in this object.</source>
        <translation>Das Schiff kommt hinaus: In diesem Objekt ist eine Öffnung von %1 m.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of “%1”.</source>
        <translation>Das Schiff kommt hinaus: Zwischen diesem Ende und dem von „%1“ fehlt eine Wand von %5 m.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of %2 at %3; %4 m.</source>
        <translation>Das Schiff kommt hinaus: Zwischen diesem Ende und dem von %2 bei %3; %4 m fehlt eine Wand von %5 m.</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before “%1”.</source>
        <translation>Das Schiff kommt hinaus: Diese Wand endet %5 m vor „%1“.</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before %2 at %3; %4 m.</source>
        <translation>Das Schiff kommt hinaus: Diese Wand endet %5 m vor %2 bei %3; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out between this and “%1”: they are %5 m apart.</source>
        <translation>Zwischen diesem und „%1“ kommt das Schiff hinaus: Sie sind %5 m voneinander entfernt.</translation>
    </message>
    <message>
        <source>The ship can get out between this and %2 at %3; %4 m: they are %5 m apart.</source>
        <translation>Zwischen diesem und %2 bei %3; %4 m kommt das Schiff hinaus: Sie sind %5 m voneinander entfernt.</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>anchor on %1</source>
        <translation>Anker an %1</translation>
    </message>
    <message>
        <source>once</source>
        <translation>einmal</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n-mal</numerusform>
            <numerusform>%n-mal</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in line %2</source>
        <translation>%1, in Zeile %2</translation>
    </message>
    <message>
        <source>%1, in lines %2</source>
        <translation>%1, in den Zeilen %2</translation>
    </message>
    <message>
        <source>What drawings within the drawing hide beyond their borders is there as well (%4).</source>
        <translation>Was Zeichnungen in der Zeichnung jenseits ihres Randes verbergen, ist mit dabei (%4).</translation>
    </message>
    <message>
        <source>The width of wide strokes was not taken over: they are walls without thickness (%4). “Stroke to Path” of Inkscape makes areas of them.</source>
        <translation>Die Breite breiter Striche wurde nicht übernommen: Sie sind Wände ohne Dicke (%4). „Kontur in Pfad umwandeln“ in Inkscape macht Flächen daraus.</translation>
    </message>
    <message>
        <source>They touch: “%1” and “%2” are in contact.</source>
        <translation>Sie berühren sich: „%1“ und „%2“ haben Kontakt.</translation>
    </message>
    <message>
        <source>Both are the same body, which does not collide with itself.</source>
        <translation>Beide sind derselbe Körper, und der kollidiert nicht mit sich selbst.</translation>
    </message>
    <message>
        <source>“%1” is switched off, so it touches nothing.</source>
        <translation>„%1“ ist ausgeschaltet und berührt deshalb nichts.</translation>
    </message>
    <message>
        <source>Neither is moved by forces: “%1” and “%2” pass through each other unless one of them is dynamic.</source>
        <translation>Keines von beiden wird durch Kräfte bewegt: „%1“ und „%2“ gehen durcheinander hindurch, solange keines davon dynamisch ist.</translation>
    </message>
    <message>
        <source>“%2” has no tags, and what has none is touched by nothing.</source>
        <translation>„%2“ hat keine Merkmale, und was keine hat, wird von nichts berührt.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3.</source>
        <translation>„%1“ berührt nicht, was „%2“ ist: %3.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3. Nor does “%2” touch what “%1” is.</source>
        <translation>„%1“ berührt nicht, was „%2“ ist: %3. Auch „%2“ berührt nicht, was „%1“ ist.</translation>
    </message>
    <message>
        <source>“%3” connects “%1” and “%2”, and bodies that it connects do not collide.</source>
        <translation>„%3“ verbindet „%1“ und „%2“, und Körper, die es verbindet, kollidieren nicht.</translation>
    </message>
    <message>
        <source>The tow rope connects “%1” and “%2”, which therefore do not collide.</source>
        <translation>Das Schleppseil verbindet „%1“ und „%2“; deshalb kollidieren sie nicht.</translation>
    </message>
    <message>
        <source>“%1” is intangible: it would be felt, but stops nothing.</source>
        <translation>„%1“ ist nicht greifbar: Es würde bemerkt, hält aber nichts auf.</translation>
    </message>
    <message>
        <source>“%1” is intangible: “%2” touches it and is felt, but nothing stops it.</source>
        <translation>„%1“ ist nicht greifbar: „%2“ berührt es und wird bemerkt, aber nicht aufgehalten.</translation>
    </message>
    <message>
        <source>Both are nothing but walls, and walls pass through each other.</source>
        <translation>Beide bestehen nur aus Wänden, und Wände gehen durcheinander hindurch.</translation>
    </message>
    <message>
        <source>“%1” and “%2” may collide, but are %3 m apart.</source>
        <translation>„%1“ und „%2“ können kollidieren, sind aber %3 m voneinander entfernt.</translation>
    </message>
    <message>
        <source>“%1” and “%2” overlap, and collide as soon as the simulation goes on.</source>
        <translation>„%1“ und „%2“ überschneiden sich und kollidieren, sobald die Simulation weiterläuft.</translation>
    </message>
    <message>
        <source>Let “%1” touch “%2”</source>
        <translation>„%1“ darf „%2“ berühren</translation>
    </message>
    <message>
        <source>Give “%1” the tag “%2”</source>
        <translation>„%1“ das Merkmal „%2“ geben</translation>
    </message>
    <message>
        <source>Make “%1” tangible</source>
        <translation>„%1“ greifbar machen</translation>
    </message>
    <message>
        <source>Let the bodies of “%1” collide</source>
        <translation>Die Körper von „%1“ kollidieren lassen</translation>
    </message>
    <message>
        <source>Back to before the run</source>
        <translation>Zurück zum Stand vor dem Lauf</translation>
    </message>
    <message>
        <source>Keep change of the level</source>
        <translation>Änderung des Levels behalten</translation>
    </message>
    <message>
        <source>Keep new object</source>
        <translation>Neues Objekt behalten</translation>
    </message>
    <message>
        <source>Keep deletion</source>
        <translation>Löschung behalten</translation>
    </message>
    <message>
        <source>Keep move</source>
        <translation>Verschiebung behalten</translation>
    </message>
    <message>
        <source>Keep tags</source>
        <translation>Merkmale behalten</translation>
    </message>
    <message>
        <source>Keep order</source>
        <translation>Reihenfolge behalten</translation>
    </message>
    <message>
        <source>Keep change</source>
        <translation>Änderung behalten</translation>
    </message>
    <message>
        <source>There is no bug capsule in the text.</source>
        <translation>Der Text enthält keine Fehlerkapsel.</translation>
    </message>
    <message>
        <source>The bug capsule was made with a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>Die Fehlerkapsel stammt aus einer neueren Version (%1; diese liest bis %2). Bitte aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>The run is longer than a bug capsule may be: %1 updates.</source>
        <translation>Der Lauf ist länger, als eine Fehlerkapsel sein darf: %1 Zeitschritte.</translation>
    </message>
    <message>
        <source>The run has ended, and nothing of it is left.</source>
        <translation>Der Lauf ist zu Ende, und nichts ist davon übrig.</translation>
    </message>
    <message>
        <source>Edits of the run</source>
        <translation>Änderungen im Lauf</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n changes</source>
        <translation>
            <numerusform>%n Änderung behalten</numerusform>
            <numerusform>%n Änderungen behalten</numerusform>
        </translation>
    </message>
    <message>
        <source>The wall is solid inside, where ship or payload start: it was drawn clockwise. Reverse it to make a cave of the rock.</source>
        <translation>Die Wand ist innen fest, wo Schiff oder Fracht starten: Sie wurde im Uhrzeigersinn gezeichnet. Kehren Sie sie um, damit aus dem Fels eine Höhle wird.</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 kann nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The file is not sound XML: line %1, column %2: %3</source>
        <translation>Die Datei ist kein fehlerfreies XML: Zeile %1, Spalte %2: %3</translation>
    </message>
    <message>
        <source>Elements of the file lie more than %1 deep in one another. Ungroup some of them, and try again.</source>
        <translation>Elemente der Datei liegen mehr als %1-fach ineinander. Lösen Sie einige Gruppen auf und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The file draws more than %1 pieces, which is more than can be imported. Take out what the level does not need, and try again.</source>
        <translation>Die Datei zeichnet mehr als %1 Teile, mehr als importiert werden können. Entfernen Sie, was das Level nicht braucht, und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Drag: move · Shift + drag: move the pivot, about which it turns</source>
        <translation>Ziehen: verschieben · Umschalt + ziehen: den Drehpunkt verschieben</translation>
    </message>
    <message>
        <source>The file “%1” is too large: at most %2 can be read.</source>
        <translation>Die Datei „%1“ ist zu groß: höchstens %2 können gelesen werden.</translation>
    </message>
    <message>
        <source>This is too large: at most %1 can be read.</source>
        <translation>Das ist zu groß: höchstens %1 können gelesen werden.</translation>
    </message>
    <message>
        <source>The file is empty. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Die Datei ist leer. Holen Sie sie noch einmal, oder nehmen Sie eine Kopie aus einer Sicherung.</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8 from here on: it is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Von hier an ist die Datei kein Text in UTF-8: sie ist beschädigt oder etwas anderes. Holen Sie sie noch einmal, oder nehmen Sie eine Kopie aus einer Sicherung.</translation>
    </message>
    <message>
        <source>There is a zero byte here, which text cannot hold: the file is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Hier steht ein Nullbyte, das in Text nicht vorkommt: die Datei ist beschädigt oder etwas anderes. Holen Sie sie noch einmal, oder nehmen Sie eine Kopie aus einer Sicherung.</translation>
    </message>
    <message>
        <source>The file ends too early: a bracket, a brace or a quotation mark is not closed. Perhaps it was not copied as a whole; fetch it again.</source>
        <translation>Die Datei endet zu früh: eine Klammer oder ein Anführungszeichen ist nicht geschlossen. Vielleicht wurde sie nicht ganz kopiert; holen Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>Neither of the two bodies can be moved by the connector; one should be dynamic.</source>
        <translation>Keinen der beiden Körper kann die Verbindung bewegen; einer sollte dynamisch sein.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>This is not a recorded flight. “Save Flight…” makes one of a run.</source>
        <translation>Das ist kein aufgezeichneter Flug. „Flug speichern…“ macht einen aus einem Lauf.</translation>
    </message>
    <message>
        <source>Line %2: “%1” is missing or not what a recorded flight has there. Correct it in a text editor, or save the flight again.</source>
        <translation>Zeile %2: „%1“ fehlt oder ist nicht, was ein aufgezeichneter Flug dort hat. Berichtigen Sie es in einem Texteditor, oder speichern Sie den Flug noch einmal.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is none that a recorded flight has. Take it out; if a newer version wrote it, update the program.</source>
        <translation>Zeile %2: das Feld „%1“ hat ein aufgezeichneter Flug nicht. Nehmen Sie es heraus; hat eine neuere Version es geschrieben, aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is given a second time. Take one of the two out.</source>
        <translation>Zeile %2: das Feld „%1“ steht ein zweites Mal da. Nehmen Sie eines von beiden heraus.</translation>
    </message>
    <message>
        <source>The flight was saved by a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>Der Flug wurde von einer neueren Version gespeichert (%1; diese liest bis %2). Bitte aktualisieren Sie das Programm.</translation>
    </message>
    <message>
        <source>The flight is longer than %1 updates, so it cannot be flown again. Save a shorter one.</source>
        <translation>Der Flug ist länger als %1 Schritte und kann daher nicht noch einmal geflogen werden. Speichern Sie einen kürzeren.</translation>
    </message>
    <message>
        <source>The bug capsule is not whole: its last line is missing. Copy it again, from its first line to its last.</source>
        <translation>Die Fehlerkapsel ist nicht vollständig: ihre letzte Zeile fehlt. Kopieren Sie sie noch einmal, von der ersten Zeile bis zur letzten.</translation>
    </message>
    <message>
        <source>The bug capsule has been changed or damaged on its way. Copy it again where it was made.</source>
        <translation>Die Fehlerkapsel wurde unterwegs verändert oder beschädigt. Kopieren Sie sie dort noch einmal, wo sie gemacht wurde.</translation>
    </message>
    <message>
        <source>The bug capsule cannot be understood at “%1”. Ask for a new one.</source>
        <translation>Die Fehlerkapsel ist bei „%1“ nicht zu verstehen. Bitten Sie um eine neue.</translation>
    </message>
    <message>
        <source>The level in the bug capsule cannot be read, so ask for a new one. Line %1 of it: %2</source>
        <translation>Das Level in der Fehlerkapsel kann nicht gelesen werden; bitten Sie um eine neue. Zeile %1 darin: %2</translation>
    </message>
    <message>
        <source>The run is larger than a bug capsule may be: %1.</source>
        <translation>Der Lauf ist größer, als eine Fehlerkapsel sein darf: %1.</translation>
    </message>
    <message>
        <source>there is no such file; it may have been moved</source>
        <translation>es gibt diese Datei nicht; vielleicht wurde sie verschoben</translation>
    </message>
    <message>
        <source>you do not have the permission; ask its owner for it</source>
        <translation>Sie haben nicht die Berechtigung; bitten Sie den Besitzer darum</translation>
    </message>
    <message>
        <source>the system does not permit it</source>
        <translation>das System erlaubt es nicht</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>es ist ein Ordner</translation>
    </message>
    <message>
        <source>what should be its folder is a file</source>
        <translation>was sein Ordner sein sollte, ist eine Datei</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>es ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>sein Name ist zu lang</translation>
    </message>
    <message>
        <source>the disk does not answer as it should; copy what it holds</source>
        <translation>der Datenträger antwortet nicht, wie er sollte; kopieren Sie, was er enthält</translation>
    </message>
    <message>
        <source>no place could be made there</source>
        <translation>dort ließ sich kein Platz anlegen</translation>
    </message>
    <message>
        <source>Change “%1” of the level</source>
        <translation>„%1“ des Levels ändern</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>„%1“ ändern</translation>
    </message>
    <message numerus="yes">
        <source>Change “%1” of %n objects</source>
        <translation>
            <numerusform>„%1“ von %n Objekt ändern</numerusform>
            <numerusform>„%1“ von %n Objekten ändern</numerusform>
        </translation>
    </message>
    <message>
        <source>“%2” is on its way through a one-way wall of “%1”, from %3; %4 to %5; %6: it came from behind, and touches nothing until all of it is in front.</source>
        <translation>„%2“ geht gerade durch eine einseitige Kante von „%1“, von %3; %4 bis %5; %6: Es kam von hinten und berührt nichts, bis alles davor ist.</translation>
    </message>
    <message>
        <source>“%2” is behind a one-way wall of “%1”, from %3; %4 to %5; %6, which is open from there.</source>
        <translation>„%2“ ist hinter einer einseitigen Kante von „%1“, von %3; %4 bis %5; %6, die von dort offen ist.</translation>
    </message>
    <message>
        <source>1 node selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Escape: select none</source>
        <translation>1 Knoten ausgewählt · ziehen: verschieben · Pfeiltasten: rücken · Entf: entfernen · Umschalt+B: auftrennen · Esc: nichts auswählen</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · release: done · Escape: cancel</source>
        <translation>Ausgewählte Knoten: %1 · loslassen: fertig · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · draw around the nodes · release: done · Escape: cancel</source>
        <translation>Ausgewählte Knoten: %1 · die Knoten umfahren · loslassen: fertig · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Cuts: %1 · release: cut · Shift: 15° · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Schnitte: %1 · loslassen: schneiden · Umschalt: 15° · Strg: Einrasten aus/an · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Pivot at %1; %2 m · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Drehpunkt bei %1; %2 m · Strg: Einrasten aus/an · Esc: abbrechen</translation>
    </message>
    <message>
        <source>Locked: clicks and drags go past it</source>
        <translation>Gesperrt: Klicken und Ziehen gehen daran vorbei</translation>
    </message>
    <message>
        <source>%1 selected · locked, so nothing changes it · Escape: select nothing</source>
        <translation>%1 ausgewählt · gesperrt, also ändert es nichts · Esc: nichts auswählen</translation>
    </message>
    <message>
        <source>A body without a name is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>Ein Körper ohne Namen besteht nicht nur aus Polygonen. Nur Polygone lassen sich vereinigen, abziehen und schneiden.</translation>
    </message>
</context>
<context>
    <name>spacetow::ArrayBar</name>
    <message>
        <source>Copies</source>
        <translation>Kopien</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Turn copies</source>
        <translation>Kopien drehen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Make the copies (Enter)</source>
        <translation>Macht die Kopien (Eingabe)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Make no copies (Escape)</source>
        <translation>Macht keine Kopien (Esc)</translation>
    </message>
    <message>
        <source>Radial array</source>
        <translation>Kreisförmige Anordnung</translation>
    </message>
    <message>
        <source>Linear array</source>
        <translation>Lineare Anordnung</translation>
    </message>
    <message>
        <source>Center x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Step x</source>
        <translation>Schritt x</translation>
    </message>
    <message>
        <source>y</source>
        <comment>of a center or step</comment>
        <translation>y</translation>
    </message>
    <message>
        <source>Of a ship, a payload and a finish a level has one: there is nothing to copy.</source>
        <translation>Schiff, Fracht und Ziellinie gibt es im Level nur einmal: Es gibt nichts zu kopieren.</translation>
    </message>
    <message>
        <source>That would be %1 objects; an array may have %2. Make fewer copies.</source>
        <translation>Das wären %1 Objekte; eine Anordnung darf %2 haben. Machen Sie weniger Kopien.</translation>
    </message>
    <message>
        <source>Select what is to be copied.</source>
        <translation>Zuerst auswählen, was kopiert werden soll.</translation>
    </message>
</context>
<context>
    <name>spacetow::Canvas</name>
    <message>
        <source>Drawing board</source>
        <translation>Zeichenfläche</translation>
    </message>
    <message>
        <source>Drawing board, running</source>
        <translation>Zeichenfläche, läuft</translation>
    </message>
</context>
<context>
    <name>spacetow::ColorField</name>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
</context>
<context>
    <name>spacetow::DifferencePanel</name>
    <message>
        <source>&amp;Compare With…</source>
        <translation>&amp;Vergleichen mit…</translation>
    </message>
    <message>
        <source>Ta&amp;ke Over</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Makes the selected objects as they are in the other level</source>
        <translation>Macht die ausgewählten Objekte so, wie sie im anderen Level sind</translation>
    </message>
    <message>
        <source>Ends comparing; the level stays as it is</source>
        <translation>Beendet den Vergleich; das Level bleibt, wie es ist</translation>
    </message>
    <message>
        <source>Nothing is compared. Choose a level file to see what is different from it.</source>
        <translation>Nichts wird verglichen. Wählen Sie eine Leveldatei, um zu sehen, was anders ist.</translation>
    </message>
    <message>
        <source>Comparing with %1…</source>
        <translation>Vergleich mit %1…</translation>
    </message>
    <message>
        <source>Nothing is different from %1.</source>
        <translation>Kein Unterschied zu %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n differences from %1</source>
        <translation>
            <numerusform>%n Unterschied zu %1</numerusform>
            <numerusform>%n Unterschiede zu %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::DiskChanges</name>
    <message>
        <source>%1 is no longer there: it was deleted, moved or renamed. Your level is still here.</source>
        <translation>%1 ist nicht mehr da: gelöscht, verschoben oder umbenannt. Ihr Level ist noch hier.</translation>
    </message>
    <message>
        <source>Save Again</source>
        <translation>Wieder speichern</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>%1 was changed by another program and has been loaded anew. Undo takes that back.</source>
        <translation>%1 wurde von einem anderen Programm geändert und neu geladen. Rückgängig nimmt das zurück.</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and you have changed it here.</source>
        <translation>%1 wurde von einem anderen Programm geändert, und Sie haben es hier geändert.</translation>
    </message>
    <message>
        <source>%1 was changed by another program and cannot be read any more. Your level is still here.</source>
        <translation>%1 wurde von einem anderen Programm geändert und lässt sich nicht mehr lesen. Ihr Level ist noch hier.</translation>
    </message>
    <message>
        <source>Not saved: %1 was changed by another program since you opened it, and saving would overwrite that.</source>
        <translation>Nicht gespeichert: %1 wurde nach dem Öffnen von einem anderen Programm geändert, und Speichern würde das überschreiben.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Überschreiben</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Meines behalten</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
</context>
<context>
    <name>spacetow::EntryBox</name>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
</context>
<context>
    <name>spacetow::Exchange</name>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>Für ein Bild dieser Größe reicht der Speicher nicht.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Drawings and maps (*.svg *.tmx *.tmj *.json);;All files (*)</source>
        <translation>Zeichnungen und Karten (*.svg *.tmx *.tmj *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>PNG pictures (*.png);;SVG drawings (*.svg)</source>
        <translation>PNG-Bilder (*.png);;SVG-Zeichnungen (*.svg)</translation>
    </message>
    <message>
        <source>%1 was imported as a whole.</source>
        <translation>%1 wurde vollständig importiert.</translation>
    </message>
    <message>
        <source>%1 was imported, but:</source>
        <translation>%1 wurde importiert, aber:</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>The picture was written to %1.</source>
        <translation>Das Bild wurde in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The screenshot was written to %1.</source>
        <translation>Das Bildschirmfoto wurde in %1 gespeichert.</translation>
    </message>
    <message>
        <source>%1 was not imported.</source>
        <translation>%1 wurde nicht importiert.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExplainPanel</name>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Wie viel</translation>
    </message>
    <message>
        <source>Explanation of the selection</source>
        <translation>Erklärung der Auswahl</translation>
    </message>
    <message>
        <source>Everything. Select one object to see what moves it, or two to hear why they do not collide.</source>
        <translation>Alles. Wählen Sie ein Objekt aus, um zu sehen, was es bewegt, oder zwei, um zu erfahren, warum sie nicht kollidieren.</translation>
    </message>
    <message>
        <source>Why do these two not collide?</source>
        <translation>Warum kollidieren diese beiden nicht?</translation>
    </message>
    <message>
        <source>Select one object, or two.</source>
        <translation>Wählen Sie ein oder zwei Objekte aus.</translation>
    </message>
    <message>
        <source>“%1” is not part of the simulation.</source>
        <translation>„%1“ ist nicht Teil der Simulation.</translation>
    </message>
    <message>
        <source>At least one of them is no body in the simulation.</source>
        <translation>Mindestens eines davon ist kein Körper in der Simulation.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExportBar</name>
    <message>
        <source>Export picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Whole level</source>
        <translation>Ganzes Level</translation>
    </message>
    <message>
        <source>What is in view</source>
        <translation>Sichtbares</translation>
    </message>
    <message>
        <source>What of the level the picture shows</source>
        <translation>Was das Bild vom Level zeigt</translation>
    </message>
    <message>
        <source>Pixels of the picture for a metre of the level.</source>
        <translation>Pixel des Bilds für einen Meter des Levels.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Leave the ground of the picture out</source>
        <translation>Lässt den Grund des Bilds weg</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Raster</translation>
    </message>
    <message>
        <source>Draw the grid as well</source>
        <translation>Zeichnet auch das Raster</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exportieren…</translation>
    </message>
    <message>
        <source>Choose a file, PNG or SVG (Enter)</source>
        <translation>Wählt eine Datei, PNG oder SVG (Eingabe)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Write no picture (Escape)</source>
        <translation>Schreibt kein Bild (Esc)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 Pixel</translation>
    </message>
    <message>
        <source>There is nothing to be seen, or the picture would be too large: at most 16,384 pixels a side and 67 million in all. Choose another scale.</source>
        <translation>Es gibt nichts zu sehen, oder das Bild würde zu groß: höchstens 16.384 Pixel je Seite und 67 Millionen insgesamt. Wählen Sie einen anderen Maßstab.</translation>
    </message>
</context>
<context>
    <name>spacetow::Finder</name>
    <message>
        <source>Find actions, levels, objects and problems</source>
        <translation>Aktionen, Level, Objekte und Probleme finden</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>&gt; actions · / levels · @ objects · ! problems · Enter: take · Esc: close</source>
        <translation>&gt; Aktionen · / Level · @ Objekte · ! Probleme · Eingabe: wählen · Esc: schließen</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Nichts heißt so.</translation>
    </message>
</context>
<context>
    <name>spacetow::FlightsPanel</name>
    <message>
        <source>No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or cave.NAME.replay.json in the same folder.</source>
        <translation>Neben diesem Level ist kein Flug gespeichert. Ein Flug zu cave.json ist eine Datei cave.replay.json oder cave.NAME.replay.json im selben Ordner.</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Flüge</translation>
    </message>
</context>
<context>
    <name>spacetow::Form</name>
    <message>
        <source>Stars</source>
        <translation>Sterne</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Einfarbig</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>Fold or unfold this section</source>
        <translation>Klappt diesen Abschnitt auf oder zu</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Zurück zur Vorgabe</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Zurück zur Vorgabe: %1</translation>
    </message>
    <message>
        <source>%1 of the %2 selected objects have this.</source>
        <translation>%1 der %2 ausgewählten Objekte haben das.</translation>
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
        <translation>Name</translation>
    </message>
    <message>
        <source>X of the guide</source>
        <translation>X der Hilfslinie</translation>
    </message>
    <message>
        <source>Y of the guide</source>
        <translation>Y der Hilfslinie</translation>
    </message>
    <message>
        <source>Angle of the guide</source>
        <translation>Winkel der Hilfslinie</translation>
    </message>
    <message>
        <source>Name of the guide</source>
        <translation>Name der Hilfslinie</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>Löscht diese Hilfslinie</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryModel</name>
    <message numerus="yes">
        <source>%n older changes that can no longer be undone</source>
        <translation>
            <numerusform>%n ältere Änderung, die sich nicht mehr rückgängig machen lässt</numerusform>
            <numerusform>%n ältere Änderungen, die sich nicht mehr rückgängig machen lassen</numerusform>
        </translation>
    </message>
    <message>
        <source>present state</source>
        <translation>jetziger Stand</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>rückgängig gemacht</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>Saved: the file holds this state</source>
        <translation>Gespeichert: Die Datei enthält diesen Stand</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Click to go back, or forward again, to the state after an edit</source>
        <translation>Ein Klick führt zum Stand nach einer Änderung zurück oder wieder vor</translation>
    </message>
</context>
<context>
    <name>spacetow::ImportBar</name>
    <message>
        <source>Progress of the import</source>
        <translation>Fortschritt des Imports</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Add what is shown to the level (Enter)</source>
        <translation>Fügt das Gezeigte dem Level hinzu (Eingabe)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave the level as it was (Escape)</source>
        <translation>Lässt das Level, wie es war (Esc)</translation>
    </message>
    <message>
        <source>What a unit of the file is: a pixel of a drawing, a pixel of a map.</source>
        <translation>Was eine Einheit der Datei ist: ein Pixel einer Zeichnung, ein Pixel einer Karte.</translation>
    </message>
    <message>
        <source>How far straight segments may stray from a curve.</source>
        <translation>Wie weit gerade Segmente von einer Kurve abweichen dürfen.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Two-way walls</source>
        <translation>Zweiseitige Linien</translation>
    </message>
    <message>
        <source>One-way walls</source>
        <translation>Einseitige Kanten</translation>
    </message>
    <message>
        <source>What lines without a fill become</source>
        <translation>Was aus Linien ohne Füllung wird</translation>
    </message>
    <message>
        <source>Fills as polygons</source>
        <translation>Füllungen als Polygone</translation>
    </message>
    <message>
        <source>Fills as walls</source>
        <translation>Füllungen als Wände</translation>
    </message>
    <message>
        <source>What filled shapes become</source>
        <translation>Was aus gefüllten Formen wird</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Neue Ebene</translation>
    </message>
    <message>
        <source>Put all of it into a new layer, named like the file</source>
        <translation>Legt alles in eine neue Ebene, die wie die Datei heißt</translation>
    </message>
    <message>
        <source>Center in view</source>
        <translation>In Ansicht zentrieren</translation>
    </message>
    <message>
        <source>Put it into the middle of the view, else where the file has it</source>
        <translation>Legt es in die Mitte der Ansicht, sonst dorthin, wo die Datei es hat</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Wird gelesen…</translation>
    </message>
    <message>
        <source>%1 objects, %2 vertices, %3 × %4 m</source>
        <translation>%1 Objekte, %2 Eckpunkte, %3 × %4 m</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
</context>
<context>
    <name>spacetow::Inspector</name>
    <message>
        <source>Level</source>
        <translation>Level</translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>A group cannot be put into itself.</source>
        <translation>Eine Gruppe kann nicht in sich selbst gelegt werden.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Which shape the fields of shapes speak of</source>
        <translation>Für welche Form die Felder der Formen gelten</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Nichts ist ausgewählt.</translation>
    </message>
    <message numerus="yes">
        <source>All %n shapes</source>
        <translation>
            <numerusform>%n Form</numerusform>
            <numerusform>Alle %n Formen</numerusform>
        </translation>
    </message>
    <message>
        <source>Shape %1: %2</source>
        <translation>Form %1: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n nodes selected</source>
        <translation>
            <numerusform>%1, %n Knoten ausgewählt</numerusform>
            <numerusform>%1, %n Knoten ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Das läge außerhalb des Bereichs dieses Felds; deshalb hat sich nichts geändert.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the values would leave the range of the field, so nothing has changed.</source>
        <translation>
            <numerusform>%n der Werte läge außerhalb des Bereichs dieses Felds; deshalb hat sich nichts geändert.</numerusform>
            <numerusform>%n der Werte lägen außerhalb des Bereichs dieses Felds; deshalb hat sich nichts geändert.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::KeyEditor</name>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Tastaturkürzel</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>Aktion oder Taste suchen</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Eigene</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Tasten wie in</translation>
    </message>
    <message>
        <source>Take all keys from a program that you know</source>
        <translation>Übernimmt alle Tasten aus einem Programm, das Sie kennen</translation>
    </message>
    <message>
        <source>Keys as &amp;in</source>
        <translation>&amp;Tasten wie in</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Aktion</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>Reset &amp;All</source>
        <translation>&amp;Alle zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take back the last change of keys</source>
        <translation>Nimmt die letzte Änderung der Tasten zurück</translation>
    </message>
    <message>
        <source>&amp;Take It Over</source>
        <translation>Über&amp;nehmen</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Give this action the keys that it came with</source>
        <translation>Gibt dieser Aktion ihre mitgelieferten Tasten</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>%1 leads to “%2” (%3).</source>
        <translation>%1 führt zu „%2“ (%3).</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now, and no longer to “%3”.</source>
        <translation>%1 führt jetzt zu „%2“ und nicht mehr zu „%3“.</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now.</source>
        <translation>%1 führt jetzt zu „%2“.</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Tasten (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Import Keys</source>
        <translation>Tasten importieren</translation>
    </message>
    <message>
        <source>Export Keys</source>
        <translation>Tasten exportieren</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>„%1“ lässt sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>“%1” is too large to be a file of keys.</source>
        <translation>„%1“ ist zu groß für eine Tastendatei.</translation>
    </message>
    <message>
        <source>Nothing was taken from “%1”.</source>
        <translation>Aus „%1“ wurde nichts übernommen.</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now.</source>
        <translation>Jetzt gelten die Tasten von „%1“.</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now. Nothing is called %2 here.</source>
        <translation>Jetzt gelten die Tasten von „%1“. Nichts heißt hier %2.</translation>
    </message>
    <message>
        <source>Wrote all keys to “%1”.</source>
        <translation>Alle Tasten in „%1“ gespeichert.</translation>
    </message>
    <message>
        <source>“%1” cannot be written: %2.</source>
        <translation>„%1“ lässt sich nicht schreiben: %2.</translation>
    </message>
    <message>
        <source>This key cannot be changed, so that there is always a way out of the game.</source>
        <translation>Diese Taste lässt sich nicht ändern, damit immer ein Weg aus dem Spiel führt.</translation>
    </message>
</context>
<context>
    <name>spacetow::KeyRecorder</name>
    <message>
        <source>Press a key</source>
        <translation>Taste drücken</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Neue Taste</translation>
    </message>
</context>
<context>
    <name>spacetow::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Search: a word, or a key as it is written</source>
        <translation>Suchen: ein Wort, oder eine Taste, wie man sie schreibt</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>No key does anything of that name.</source>
        <translation>Keine Taste tut etwas mit diesem Namen.</translation>
    </message>
</context>
<context>
    <name>spacetow::Legend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Legende der Einblendungen</translation>
    </message>
    <message>
        <source>Hide the legend</source>
        <translation>Die Legende ausblenden</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Ausschalten</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Eine andere Farbe wählen</translation>
    </message>
    <message>
        <source>What is too small at this zoom is not drawn</source>
        <translation>Was in dieser Vergrößerung zu klein ist, wird nicht gezeichnet</translation>
    </message>
    <message>
        <source>Names that would lie on others are left out</source>
        <translation>Namen, die auf anderen lägen, sind weggelassen</translation>
    </message>
</context>
<context>
    <name>spacetow::LevelPanel</name>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Das läge außerhalb des Bereichs dieses Felds; deshalb hat sich nichts geändert.</translation>
    </message>
</context>
<context>
    <name>spacetow::MainWindow</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message numerus="yes">
        <source>The level has %n errors and may not play as it should; see Problems.</source>
        <translation>
            <numerusform>Das Level hat %n Fehler und spielt sich womöglich nicht wie gedacht; siehe Probleme.</numerusform>
            <numerusform>Das Level hat %n Fehler und spielt sich womöglich nicht wie gedacht; siehe Probleme.</numerusform>
        </translation>
    </message>
    <message>
        <source>About SpaceTow Studio</source>
        <translation>Über SpaceTow Studio</translation>
    </message>
    <message>
        <source>SpaceTow Studio %1</source>
        <translation>SpaceTow Studio %1</translation>
    </message>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.

Free software under the MIT license. Made with Qt %1 and Eigen.</source>
        <translation>Level zeichnen und fliegen: ein Leveleditor und Physik-Sandkasten.

Freie Software unter der MIT-Lizenz. Erstellt mit Qt %1 und Eigen.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>%1[*] - SpaceTow Studio</source>
        <translation>%1[*] - SpaceTow Studio</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>There is nothing on the clipboard that can be pasted here.</source>
        <translation>Die Zwischenablage enthält nichts, was sich hier einfügen lässt.</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objekt</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Spiel</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>O&amp;verlays</source>
        <translation>Einb&amp;lendungen</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Bedienfelder</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Hauptleiste</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Noch keine Dateien</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>Liste &amp;leeren</translation>
    </message>
    <message>
        <source>Select &amp;Under Pointer</source>
        <translation>Unter dem &amp;Zeiger auswählen</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>Ei&amp;nrasten</translation>
    </message>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>Raster&amp;schritt</translation>
    </message>
    <message>
        <source>&amp;Order</source>
        <translation>&amp;Reihenfolge</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Ausr&amp;ichten</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>U&amp;mformen</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>P&amp;fad</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Level</translation>
    </message>
    <message>
        <source>New level</source>
        <translation>Neues Level</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 geöffnet</translation>
    </message>
    <message>
        <source>snaps to: %1</source>
        <translation>rastet ein: %1</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>&amp;Unterraster</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>Er&amp;scheinungsbild</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>%1 neu geladen</translation>
    </message>
    <message>
        <source>Was open at the end of the last run, but is gone: %1</source>
        <translation>War zuletzt geöffnet, ist aber nicht mehr da: %1</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <translation>mitgeliefert</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Level</translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>won</source>
        <translation>gewonnen</translation>
    </message>
    <message>
        <source>crashed</source>
        <translation>abgestürzt</translation>
    </message>
    <message>
        <source>game over</source>
        <translation>Game over</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>im Spiel</translation>
    </message>
    <message>
        <source>%1[*] (%2) - SpaceTow Studio</source>
        <translation>%1[*] (%2) - SpaceTow Studio</translation>
    </message>
    <message>
        <source>No level is open · arrows, Tab and Enter choose one</source>
        <translation>Kein Level ist offen · Pfeiltasten, Tab und Eingabe wählen eines</translation>
    </message>
    <message>
        <source>Nothing was left unsaved.</source>
        <translation>Nichts blieb ungespeichert.</translation>
    </message>
    <message>
        <source>Take back the level as it was saved then, as one edit; its file stays as it is</source>
        <translation>Holt das damals gespeicherte Level als eine einzige Änderung zurück; seine Datei bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>No former versions yet</source>
        <translation>Noch keine früheren Fassungen</translation>
    </message>
    <message>
        <source>&amp;Backups</source>
        <translation>Siche&amp;rungen</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fe&amp;nster</translation>
    </message>
    <message>
        <source>Should the program end all of a sudden, what is not saved will be lost:</source>
        <translation>Falls das Programm plötzlich endet, geht Ungespeichertes verloren:</translation>
    </message>
    <message>
        <source>%1 is open in another window too. What is saved there will arrive here.</source>
        <translation>%1 ist auch in einem anderen Fenster offen. Was dort gespeichert wird, kommt hier an.</translation>
    </message>
    <message>
        <source>Texts in this language from now on, in all windows</source>
        <translation>Texte von nun an in dieser Sprache, in allen Fenstern</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Sprac&amp;he</translation>
    </message>
    <message>
        <source>The game was ended: so many bodies lie in the same place that the computer&apos;s memory would not hold what happens between them. Move them apart, and play again.</source>
        <translation>Das Spiel wurde beendet: An derselben Stelle liegen so viele Körper, dass der Speicher des Computers für das, was zwischen ihnen geschieht, nicht reichen würde. Schieben Sie sie auseinander und spielen Sie erneut.</translation>
    </message>
    <message>
        <source>The game was ended: there is not enough memory for this level. Nothing of the level is lost.</source>
        <translation>Das Spiel wurde beendet: Für dieses Level reicht der Speicher nicht. Vom Level ist nichts verloren.</translation>
    </message>
    <message>
        <source>what was not saved of %1</source>
        <translation>was von %1 nicht gespeichert war</translation>
    </message>
    <message>
        <source>Write plots</source>
        <translation>Kurven schreiben</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save flight</source>
        <translation>Flug speichern</translation>
    </message>
    <message>
        <source>Flights (*.replay.json)</source>
        <translation>Flüge (*.replay.json)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>The plots are in “%1”.</source>
        <translation>Die Kurven stehen in „%1“.</translation>
    </message>
    <message>
        <source>Pulling · move: pull further · let the button go: throw</source>
        <translation>Ziehen am Körper · Bewegen: weiter ziehen · Taste loslassen: werfen</translation>
    </message>
    <message>
        <source>Playing a recorded flight · who steers takes over · %1: back to the editor</source>
        <translation>Aufgezeichneter Flug läuft · wer steuert, übernimmt · %1: zurück zum Editor</translation>
    </message>
    <message>
        <source>%1: follow the ship again</source>
        <translation>%1: wieder dem Schiff folgen</translation>
    </message>
    <message>
        <source>Playing · drag a body: pull it · wheel, right drag: move the view · %1 held: back in time · %2: back to the editor · Esc: menu</source>
        <translation>Spiel läuft · Körper ziehen: an ihm zerren · Mausrad, Ziehen mit rechts: Ansicht bewegen · %1 gedrückt halten: in der Zeit zurück · %2: zurück zum Editor · Esc: Menü</translation>
    </message>
    <message>
        <source>Simulation held · click: select · drag: move · %1: go on from here · %2: next frame · %3: back to the editor</source>
        <translation>Simulation angehalten · Klick: auswählen · Ziehen: verschieben · %1: von hier fortsetzen · %2: Einzelbild weiter · %3: zurück zum Editor</translation>
    </message>
    <message>
        <source>Simulation running · click: select · drag: pull a body, move what stands still · %1: hold · %2: back to the editor</source>
        <translation>Simulation läuft · Klick: auswählen · Ziehen: an einem Körper zerren, Stillstehendes verschieben · %1: anhalten · %2: zurück zum Editor</translation>
    </message>
    <message>
        <source>Here begins a new level.
%1: draw the walls of a cave, anticlockwise
%2: place ship, payload and finish
%3: play
%4, %5: draw boxes and balls
%6: simulate
%7: find everything else</source>
        <translation>Hier beginnt ein neues Level.
%1: die Wände einer Höhle zeichnen, gegen den Uhrzeigersinn
%2: Schiff, Fracht und Ziellinie setzen
%3: spielen
%4, %5: Kisten und Bälle zeichnen
%6: simulieren
%7: alles andere finden</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>in Simulation</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simulieren</translation>
    </message>
    <message>
        <source>Held within an update, after iteration %1 of %2 · %3: next iteration · %4: go on from here</source>
        <translation>Angehalten innerhalb einer Aktualisierung, nach Iteration %1 von %2 · %3: nächste Iteration · %4: von hier weiter</translation>
    </message>
    <message>
        <source>Held · %1: go on from here · %2: next frame · %3: previous frame · %4: back to the editor</source>
        <translation>Angehalten · %1: von hier weiter · %2: nächstes Bild · %3: voriges Bild · %4: zurück zum Editor</translation>
    </message>
    <message>
        <source> · it will move; walls and lines stand still</source>
        <translation> · es wird sich bewegen; Wände und Linien stehen still</translation>
    </message>
    <message>
        <source>Getting ready to run: %1 s so far · %2: leave it</source>
        <translation>Der Lauf wird vorbereitet: bisher %1 s · %2: abbrechen</translation>
    </message>
    <message>
        <source>Too much for this computer: %1 s behind real time · %2: back to the editor</source>
        <translation>Zu viel für diesen Rechner: %1 s hinter der Echtzeit · %2: zurück zum Editor</translation>
    </message>
    <message>
        <source>Simulating the run: %1 of %2 s so far · %3: leave it</source>
        <translation>Der Lauf wird simuliert: bisher %1 von %2 s · %3: abbrechen</translation>
    </message>
    <message>
        <source>Playing a recorded simulation · %1: back to the editor</source>
        <translation>Aufgezeichnete Simulation läuft · %1: zurück zum Editor</translation>
    </message>
    <message>
        <source>A connector is pasted together with the two bodies that it joins.</source>
        <translation>Eine Verbindung wird zusammen mit den beiden Körpern eingefügt, die sie verbindet.</translation>
    </message>
    <message>
        <source>A level has one ship, one payload and one finish, and this one has them already.</source>
        <translation>Ein Level hat ein Schiff, eine Fracht und eine Ziellinie, und dieses hat sie schon.</translation>
    </message>
    <message>
        <source>Nothing that is selected has an edge at the pointer.</source>
        <translation>Nichts Ausgewähltes hat am Zeiger eine Kante.</translation>
    </message>
    <message>
        <source>Edit N&amp;odes</source>
        <translation>Kn&amp;oten bearbeiten</translation>
    </message>
    <message>
        <source>%1: unlock all</source>
        <translation>%1: alles entsperren</translation>
    </message>
    <message>
        <source>Reading %1: %2 s so far · %3: leave it</source>
        <translation>%1 wird gelesen: bisher %2 s · %3: abbrechen</translation>
    </message>
</context>
<context>
    <name>spacetow::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>spacetow::Minimap</name>
    <message>
        <source>Minimap</source>
        <translation>Minikarte</translation>
    </message>
    <message>
        <source>Click or drag: go there · wheel: zoom · arrows: move the view</source>
        <translation>Klick oder Ziehen: dorthin gehen · Mausrad: zoomen · Pfeiltasten: Ansicht verschieben</translation>
    </message>
</context>
<context>
    <name>spacetow::MotionLine</name>
    <message>
        <source>Now, while it runs</source>
        <translation>Jetzt, während es läuft</translation>
    </message>
    <message>
        <source>How the body moves now, while it runs; the fields say where it starts</source>
        <translation>Wie sich der Körper jetzt im Lauf bewegt; die Felder geben an, wo er startet</translation>
    </message>
    <message>
        <source>Now: x %1 · y %2 m · %3°</source>
        <translation>Jetzt: x %1 · y %2 m · %3°</translation>
    </message>
    <message>
        <source>%1 m/s (x %2 · y %3) · %4°/s</source>
        <translation>%1 m/s (x %2 · y %3) · %4°/s</translation>
    </message>
    <message>
        <source>Now: %1 m long, %2 m at rest</source>
        <translation>Jetzt: %1 m lang, %2 m in Ruhe</translation>
    </message>
    <message>
        <source>pushes with %1 N</source>
        <translation>drückt mit %1 N</translation>
    </message>
    <message>
        <source>pulls with %1 N</source>
        <translation>zieht mit %1 N</translation>
    </message>
    <message>
        <source>Now: not there any more</source>
        <translation>Jetzt: nicht mehr vorhanden</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesDelegate</name>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Das läge außerhalb der Karte; sie endet %1 m vom Ursprung.</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesModel</name>
    <message>
        <source>shape %1: %2</source>
        <translation>Form %1: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Knoten</translation>
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
        <translation>Knoten der bearbeiteten Objekte</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Insert a node halfway to the next one</source>
        <translation>Fügt auf halbem Weg zum nächsten einen Knoten ein</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected nodes</source>
        <translation>Löscht die ausgewählten Knoten</translation>
    </message>
    <message>
        <source>Double click or type to change a coordinate; with several rows selected, in all of them</source>
        <translation>Doppelklick oder Tippen ändert eine Koordinate; bei mehreren ausgewählten Zeilen in allen</translation>
    </message>
</context>
<context>
    <name>spacetow::NumberField</name>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>A whole number</source>
        <translation>Eine ganze Zahl</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>Eine Zahl</translation>
    </message>
    <message>
        <source>%1 above %2 and up to %3</source>
        <translation>%1 über %2 und bis %3</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 von %2 bis %3</translation>
    </message>
    <message>
        <source>%1, or nothing</source>
        <translation>%1 oder nichts</translation>
    </message>
    <message>
        <source>Type a number or an expression such as 2*pi/3, 20 cm, +=0.5 or *=2 · Up, Down, wheel: step · Shift: finer · Ctrl: coarser</source>
        <translation>Zahl oder Ausdruck wie 2*pi/3, 20 cm, +=0.5 oder *=2 · Auf, Ab, Mausrad: schrittweise · Umschalt: feiner · Strg: gröber</translation>
    </message>
    <message>
        <source>Exactly %1 %2</source>
        <translation>Genau %1 %2</translation>
    </message>
    <message>
        <source>%1 above %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 of %2 or more</source>
        <translation>%1 ab %2</translation>
    </message>
    <message>
        <source>The result is too large.</source>
        <translation>Das Ergebnis ist zu groß.</translation>
    </message>
    <message>
        <source>%1 is not possible: %2.</source>
        <translation>%1 ist nicht möglich: %2.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>„%1“ ist keine Zahl.</translation>
    </message>
</context>
<context>
    <name>spacetow::ObjectField</name>
    <message>
        <source>There is no object with this key.</source>
        <translation>Es gibt kein Objekt mit diesem Schlüssel.</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”; write the name or the key of another object.</source>
        <translation>Nichts hier heißt „%1“; gebraucht wird der Name oder Schlüssel eines anderen Objekts.</translation>
    </message>
    <message>
        <source>Several objects are called “%1”; write the key of the one you mean.</source>
        <translation>Mehrere Objekte heißen „%1“; gebraucht wird der Schlüssel des gemeinten.</translation>
    </message>
    <message>
        <source>Choose from a list (Down)</source>
        <translation>Aus einer Liste wählen (Ab)</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translation>%1, Schlüssel %2</translation>
    </message>
    <message>
        <source>Select it and bring it into the middle of the view</source>
        <translation>Auswählen und in die Mitte der Ansicht holen</translation>
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
        <translation>Farbe der Gruppe. Ein Klick wählt eine andere</translation>
    </message>
    <message>
        <source>Hidden in the editor; played all the same. Click to show it</source>
        <translation>Im Editor ausgeblendet, im Spiel trotzdem dabei. Ein Klick blendet es ein</translation>
    </message>
    <message>
        <source>Visible. Click to hide it in the editor</source>
        <translation>Sichtbar. Ein Klick blendet es im Editor aus</translation>
    </message>
    <message>
        <source>Locked: not picked on the canvas, moved or deleted. Click to unlock it</source>
        <translation>Gesperrt: auf der Zeichenfläche nicht auswählbar, nicht verschiebbar, nicht löschbar. Ein Klick entsperrt es</translation>
    </message>
    <message>
        <source>Not locked. Click to lock it against changes</source>
        <translation>Nicht gesperrt. Ein Klick sperrt es gegen Änderungen</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>ausgeblendet</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>gesperrt</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>nicht gesperrt</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerPanel</name>
    <message>
        <source>What is locked stays where it is; unlock it to move it.</source>
        <translation>Was gesperrt ist, bleibt, wo es ist; erst entsperrt lässt es sich verschieben.</translation>
    </message>
    <message>
        <source>Find: name, kind:wall, tag:ice</source>
        <translation>Suche: Name, kind:wall, tag:ice</translation>
    </message>
    <message>
        <source>Filter of the objects</source>
        <translation>Filter der Objekte</translation>
    </message>
    <message>
        <source>Choose what to find</source>
        <translation>Wählt, was gesucht wird</translation>
    </message>
    <message>
        <source>Color of the Group</source>
        <translation>Farbe der Gruppe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Merkmal</translation>
    </message>
    <message>
        <source>Shows the objects whose name holds these words, with their groups.
kind:wall, tag:ice, is:hidden and is:locked ask for other things; a minus before a word turns it round. Enter selects all that is found.
The list shows what is drawn on top first.</source>
        <translation>Zeigt die Objekte, deren Name diese Wörter enthält, mit ihren Gruppen.
kind:wall, tag:ice, is:hidden und is:locked fragen nach anderem; ein Minus vor einem Wort kehrt es um. Die Eingabetaste wählt alles Gefundene aus.
Die Liste zeigt zuerst, was zuoberst gezeichnet ist.</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerView</name>
    <message>
        <source>Objects of the level</source>
        <translation>Objekte des Levels</translation>
    </message>
    <message>
        <source>No object matches the filter.</source>
        <translation>Kein Objekt passt zum Filter.</translation>
    </message>
    <message>
        <source>The level has no objects.</source>
        <translation>Das Level hat keine Objekte.</translation>
    </message>
</context>
<context>
    <name>spacetow::OverlayColorsDialog</name>
    <message>
        <source>&amp;Set of colors:</source>
        <translation>&amp;Farbpalette:</translation>
    </message>
    <message>
        <source>&amp;Forget Own Colors</source>
        <translation>Eigene Farben &amp;vergessen</translation>
    </message>
    <message>
        <source>Colors of the overlays</source>
        <translation>Farben der Einblendungen</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Okabe and Ito, safe with any color vision</source>
        <translation>Okabe und Ito, für jedes Farbsehen geeignet</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Eine andere Farbe wählen</translation>
    </message>
    <message>
        <source>The color of the set again</source>
        <translation>Wieder die Farbe der Palette</translation>
    </message>
    <message>
        <source>%1: the color of the set again</source>
        <translation>%1: wieder die Farbe der Palette</translation>
    </message>
</context>
<context>
    <name>spacetow::PauseMenu</name>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Back to the editor</source>
        <translation>Zurück zum Editor</translation>
    </message>
    <message>
        <source>You made it!</source>
        <translation>Geschafft!</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Abgestürzt</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Game over</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>Das Spielen beenden</translation>
    </message>
    <message>
        <source>Go on playing</source>
        <translation>Weiterspielen</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Das Level von vorn beginnen</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotPanel</name>
    <message>
        <source>Quantity of the selection</source>
        <translation>Größe der Auswahl</translation>
    </message>
    <message>
        <source>What of the selected body or connector, or of everything, is to be plotted</source>
        <translation>Was vom ausgewählten Körper, von der ausgewählten Verbindung oder von allem aufgetragen werden soll</translation>
    </message>
    <message>
        <source>Add curve</source>
        <translation>Kurve hinzufügen</translation>
    </message>
    <message>
        <source>x against y</source>
        <translation>x gegen y</translation>
    </message>
    <message>
        <source>The second curve against the first, in place of all over time</source>
        <translation>Die zweite Kurve über der ersten statt aller über der Zeit</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Write what is plotted into a file that spreadsheets read</source>
        <translation>Schreibt die Kurven in eine Datei, die Tabellenkalkulationen lesen</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Remove all curves</source>
        <translation>Alle Kurven entfernen</translation>
    </message>
    <message>
        <source>Drift: how far energy has come from its first value, as a share of the most that was ever in motion or in springs; and momentum, as a share of the most that all bodies had</source>
        <translation>Drift: wie weit sich die Energie von ihrem Anfangswert entfernt hat, als Anteil des Höchsten, was je in Bewegung oder in Federn steckte; und der Impuls, als Anteil des Höchsten, was alle Körper hatten</translation>
    </message>
    <message>
        <source>Select a body or a connector, choose a quantity and add its curve. It grows while the level is played or simulated.</source>
        <translation>Wählen Sie einen Körper oder eine Verbindung aus, dann eine Größe, und fügen Sie deren Kurve hinzu. Sie wächst, während das Level gespielt oder simuliert wird.</translation>
    </message>
    <message>
        <source>Remove the curve “%1”</source>
        <translation>Die Kurve „%1“ entfernen</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>Nichts läuft.</translation>
    </message>
    <message>
        <source>Energy %1 J, %2 J since the start (drift %3) · momentum %4 kg m/s (drift %5)</source>
        <translation>Energie %1 J, %2 J seit dem Start (Drift %3) · Impuls %4 kg m/s (Drift %5)</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotView</name>
    <message>
        <source>Plot</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>Wheel: zoom · drag: move · double-click: show everything</source>
        <translation>Mausrad: zoomen · Ziehen: verschieben · Doppelklick: alles zeigen</translation>
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
        <translation>Beheben</translation>
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
        <source>Problems of the level</source>
        <translation>Probleme des Levels</translation>
    </message>
    <message>
        <source>Nothing to complain about.</source>
        <translation>Nichts zu beanstanden.</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Prüfung läuft…</translation>
    </message>
    <message>
        <source>Show notes: what could be tidied</source>
        <translation>Hinweise zeigen: was sich aufräumen ließe</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Warnungen zeigen</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Fehler zeigen</translation>
    </message>
    <message>
        <source>Show the problems that are hidden in this level, too</source>
        <translation>Auch die in diesem Level ausgeblendeten Probleme zeigen</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Behebt alle Probleme, deren Lösung nichts Gewolltes ändert</translation>
    </message>
    <message>
        <source>Hidden: %1</source>
        <translation>Ausgeblendet: %1</translation>
    </message>
    <message>
        <source>Fix all that is safe: %1</source>
        <translation>Sicher Behebbares beheben: %1</translation>
    </message>
    <message>
        <source>Nothing else: the rest is filtered out or hidden.</source>
        <translation>Sonst nichts: Der Rest ist ausgefiltert oder ausgeblendet.</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>Beheben: %1</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Wieder zeigen</translation>
    </message>
    <message>
        <source>Hide it in this level</source>
        <translation>In diesem Level ausblenden</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Text kopieren</translation>
    </message>
    <message>
        <source>Nothing was found that would cure this by itself.</source>
        <translation>Es wurde nichts gefunden, was dies von selbst beheben würde.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfileChart</name>
    <message>
        <source>Times of the last updates</source>
        <translation>Zeiten der letzten Zeitschritte</translation>
    </message>
    <message>
        <source>The last updates, newest at the right; the colors are those of the stages below</source>
        <translation>Die letzten Zeitschritte, der neueste rechts; die Farben sind die der Abschnitte unten</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Times are taken while the level is played or simulated.</source>
        <translation>Zeiten werden gemessen, während das Level gespielt oder simuliert wird.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfilePanel</name>
    <message>
        <source>Stage, ms</source>
        <translation>Abschnitt, ms</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>Jetzt</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Times and counters</source>
        <translation>Zeiten und Zähler</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Zusammen</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryBar</name>
    <message>
        <source>The program ended with work that was not saved:</source>
        <translation>Das Programm endete mit ungespeicherter Arbeit:</translation>
    </message>
    <message>
        <source>Not now: it is kept, and offered again</source>
        <translation>Später: bleibt erhalten, wird wieder angeboten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Beside the file as it is now:</source>
        <translation>Neben der Datei, wie sie jetzt ist:</translation>
    </message>
    <message>
        <source>There is no file to compare it with:</source>
        <translation>Es gibt keine Datei zum Vergleichen:</translation>
    </message>
    <message>
        <source>It is the same as the file.</source>
        <translation>Es gleicht der Datei.</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryRow</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>nie gespeichert</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleichen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Go on with this level; its file stays as it is until you save</source>
        <translation>Setzt die Arbeit an diesem Level fort; seine Datei bleibt, wie sie ist, bis Sie speichern</translation>
    </message>
    <message>
        <source>Do not offer this any more</source>
        <translation>Bietet dies nicht mehr an</translation>
    </message>
    <message>
        <source>Discarded.</source>
        <translation>Verworfen.</translation>
    </message>
    <message>
        <source>Say and show what differs from the file</source>
        <translation>Sagen und zeigen, was von der Datei abweicht</translation>
    </message>
</context>
<context>
    <name>spacetow::Ruler</name>
    <message>
        <source>Ruler above the drawing board</source>
        <translation>Lineal über der Zeichenfläche</translation>
    </message>
    <message>
        <source>Ruler beside the drawing board</source>
        <translation>Lineal neben der Zeichenfläche</translation>
    </message>
    <message>
        <source>Metres; drag a horizontal guide out of the ruler</source>
        <translation>Meter; Ziehen holt eine waagerechte Hilfslinie aus dem Lineal</translation>
    </message>
    <message>
        <source>Metres; drag a vertical guide out of the ruler</source>
        <translation>Meter; Ziehen holt eine senkrechte Hilfslinie aus dem Lineal</translation>
    </message>
</context>
<context>
    <name>spacetow::RulerCorner</name>
    <message>
        <source>Corner of the rulers</source>
        <translation>Ecke der Lineale</translation>
    </message>
    <message>
        <source>Metres; drag a slanting guide out of the corner</source>
        <translation>Meter; Ziehen holt eine schräge Hilfslinie aus der Ecke</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesList</name>
    <message>
        <source>Is kept only together with:
%1</source>
        <translation>Wird nur zusammen behalten mit:
%1</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesPanel</name>
    <message>
        <source>Keep &amp;All</source>
        <translation>&amp;Alle behalten</translation>
    </message>
    <message>
        <source>Keep &amp;Ticked</source>
        <translation>Ange&amp;hakte behalten</translation>
    </message>
    <message>
        <source>&amp;Discard All</source>
        <translation>Alle &amp;verwerfen</translation>
    </message>
    <message>
        <source>Changes made in this run</source>
        <translation>Änderungen in diesem Lauf</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, each as one step that can be undone</source>
        <translation>Übernimmt alle diese Änderungen ins Level, jede als einen Schritt, der sich rückgängig machen lässt</translation>
    </message>
    <message>
        <source>Makes those that are ticked in the level, and forgets the others</source>
        <translation>Übernimmt die angehakten ins Level und vergisst die anderen</translation>
    </message>
    <message>
        <source>Leaves the level as it was before the run; Undo brings the changes back</source>
        <translation>Lässt das Level, wie es vor dem Lauf war; Rückgängig holt die Änderungen zurück</translation>
    </message>
    <message numerus="yes">
        <source>%n changes were made in this run. The level is as before; keep what you like.</source>
        <translation>
            <numerusform>In diesem Lauf wurde %n Änderung vorgenommen. Das Level ist wie zuvor; behalten Sie sie, wenn Sie möchten.</numerusform>
            <numerusform>In diesem Lauf wurden %n Änderungen vorgenommen. Das Level ist wie zuvor; behalten Sie, was Sie möchten.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing waits to be kept. What is changed in a level while it runs is listed here when the run ends.</source>
        <translation>Nichts wartet darauf, behalten zu werden. Was in einem Level geändert wird, während es läuft, steht nach dem Ende des Laufs hier.</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, as one step that can be undone</source>
        <translation>Nimmt alle diese Änderungen im Level vor, als einen Schritt, der rückgängig gemacht werden kann</translation>
    </message>
    <message>
        <source>The end of the run is undone: what was changed in it is in the level again. Redo takes it out, and lists it to be kept.</source>
        <translation>Das Ende des Laufs ist zurückgenommen: was darin geändert wurde, ist wieder im Level. Wiederholen nimmt es heraus und listet es zum Behalten auf.</translation>
    </message>
</context>
<context>
    <name>spacetow::ScrubLabel</name>
    <message>
        <source>Drag: change the number · Shift: a tenth as fast · Ctrl: in whole steps · Escape: take it back</source>
        <translation>Ziehen: Zahl ändern · Umschalt: zehnmal langsamer · Strg: in ganzen Schritten · Esc: zurücknehmen</translation>
    </message>
</context>
<context>
    <name>spacetow::StatusLine</name>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>Raster&amp;schritt</translation>
    </message>
    <message>
        <source>Next problem (F4)</source>
        <translation>Nächstes Problem (F4)</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>x %1  y %2 m</source>
        <translation>x %1  y %2 m</translation>
    </message>
    <message>
        <source>, %1 × %2 m</source>
        <translation>, %1 × %2 m</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n ausgewählt</numerusform>
            <numerusform>%n ausgewählt</numerusform>
        </translation>
    </message>
    <message>
        <source>Snap %1 m</source>
        <translation>Einrasten %1 m</translation>
    </message>
    <message>
        <source>Snap off</source>
        <translation>Einrasten aus</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n Fehler</numerusform>
            <numerusform>%n Fehler</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n Warnung</numerusform>
            <numerusform>%n Warnungen</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Keine Probleme</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>&amp;Unterraster</translation>
    </message>
    <message>
        <source>How points snap; Shift+G switches the grid, Shift+S the rest, Ctrl suspends both</source>
        <translation>Wie Punkte einrasten; Umschalt+G schaltet das Raster, Umschalt+S den Rest, Strg setzt beides aus</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keines</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>Snap to objects</source>
        <translation>An Objekten einrasten</translation>
    </message>
</context>
<context>
    <name>spacetow::TagGrid</name>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>Neues Merkmal</translation>
    </message>
    <message>
        <source>Name another of the 32 tags</source>
        <translation>Ein weiteres der 32 Merkmale benennen</translation>
    </message>
    <message>
        <source>%1 – double-click or F2 to rename, right-click for more</source>
        <translation>%1 – Doppelklick oder F2: umbenennen, Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Farbe…</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Farbe von „%1“</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>everything except</source>
        <translation>alles außer</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later, but for those crossed out; click for everything</source>
        <translation>Berührt alles, was ein Merkmal hat, auch später angelegte, außer den durchgestrichenen; Klick: alles</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later; click for nothing, click a tag to leave it out</source>
        <translation>Berührt alles, was ein Merkmal hat, auch später angelegte; Klick: nichts, Klick auf ein Merkmal: es auslassen</translation>
    </message>
    <message>
        <source>Touches the marked tags only; click for everything</source>
        <translation>Berührt nur die markierten Merkmale; Klick: alles</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Alle mit diesem Merkmal auswählen</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixPanel</name>
    <message>
        <source>Name of the tag</source>
        <translation>Name des Merkmals</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Alle mit diesem Merkmal auswählen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Farbe…</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Farbe von „%1“</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixView</name>
    <message>
        <source>Tag matrix</source>
        <translation>Merkmalmatrix</translation>
    </message>
    <message>
        <source>No object is “%1” or “%2”.</source>
        <translation>Kein Objekt ist „%1“ oder „%2“.</translation>
    </message>
    <message>
        <source>“%1” and “%2” pass through each other.</source>
        <translation>„%1“ und „%2“ gehen durcheinander hindurch.</translation>
    </message>
    <message>
        <source>“%1” and “%2” touch each other.</source>
        <translation>„%1“ und „%2“ berühren einander.</translation>
    </message>
    <message>
        <source>Some that are “%1” and “%2” touch each other.</source>
        <translation>Manche, die „%1“ und „%2“ sind, berühren einander.</translation>
    </message>
    <message>
        <source>The rules of the game say so.</source>
        <translation>So wollen es die Spielregeln.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are “%1”; double-click to select them, right-click for more</source>
        <translation>
            <numerusform>%n Objekt ist „%1“; Doppelklick: auswählen, Rechtsklick: mehr</numerusform>
            <numerusform>%n Objekte sind „%1“; Doppelklick: auswählen, Rechtsklick: mehr</numerusform>
        </translation>
    </message>
    <message>
        <source>They did touch in the last run.</source>
        <translation>Im letzten Lauf haben sie sich berührt.</translation>
    </message>
    <message>
        <source>They met in the last run, and passed through each other.</source>
        <translation>Im letzten Lauf sind sie sich begegnet und durcheinander hindurchgegangen.</translation>
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
        <translation>Wie schnell die Zeit läuft</translation>
    </message>
</context>
<context>
    <name>spacetow::TimelineScale</name>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Payload taken in tow</source>
        <translation>Fracht in Schlepp genommen</translation>
    </message>
    <message>
        <source>Payload let go</source>
        <translation>Fracht losgelassen</translation>
    </message>
    <message>
        <source>Crash</source>
        <translation>Absturz</translation>
    </message>
    <message>
        <source>New attempt</source>
        <translation>Neuer Versuch</translation>
    </message>
    <message>
        <source>Win</source>
        <translation>Sieg</translation>
    </message>
    <message>
        <source>Edit of the level</source>
        <translation>Änderung des Levels</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, bei %2</translation>
    </message>
    <message>
        <source>The selected body touches something</source>
        <translation>Der ausgewählte Körper berührt etwas</translation>
    </message>
    <message>
        <source>The selected body parts from something</source>
        <translation>Der ausgewählte Körper löst sich von etwas</translation>
    </message>
    <message>
        <source>Dashed on the canvas: what was to come before the run was changed. Without a ship these are the ways of the selected body and of up to %1 others.</source>
        <translation>Gestrichelt auf der Leinwand: was gekommen wäre, bevor der Lauf geändert wurde. Ohne Schiff sind das die Wege des ausgewählten Körpers und von bis zu %1 anderen.</translation>
    </message>
</context>
<context>
    <name>spacetow::TransformBar</name>
    <message>
        <source>Transform</source>
        <translation>Umformen</translation>
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
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Drehen um</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relativ</translation>
    </message>
    <message>
        <source>Move by metres and scale by percent instead of to a place and size</source>
        <translation>Verschiebt um Meter und skaliert um Prozent statt an einen Ort und auf eine Größe</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this bar (Escape)</source>
        <translation>Schließt diese Leiste (Esc)</translation>
    </message>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Das läge außerhalb der Karte; sie endet %1 m vom Ursprung.</translation>
    </message>
</context>
<context>
    <name>spacetow::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Draw a cave, and fly your load out of it.</source>
        <translation>Zeichnen Sie eine Höhle, und fliegen Sie Ihre Fracht hinaus.</translation>
    </message>
    <message>
        <source>&amp;New Level</source>
        <translation>&amp;Neues Level</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Recent levels</source>
        <translation>Zuletzt geöffnete Level</translation>
    </message>
    <message>
        <source>Levels that come with the program; what you open is a copy</source>
        <translation>Mitgelieferte Level; geöffnet wird eine Kopie</translation>
    </message>
    <message>
        <source>&amp;Show this page at start and when the last level is closed</source>
        <translation>Diese Seite beim &amp;Start und nach dem Schließen des letzten Levels zeigen</translation>
    </message>
    <message>
        <source>Sandbox</source>
        <translation>Sandkasten</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Level</translation>
    </message>
    <message>
        <source>Sandboxes: each shows one thing that the physics does, and says what to try</source>
        <translation>Sandkästen: Jeder zeigt etwas, was die Physik kann, und sagt, was sich ausprobieren lässt</translation>
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
        <translation>Zoom: Prozentwert zum Eingeben oder Auswählen; Strg+0 zeigt die Originalgröße</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
</TS>
