<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Not while a game is running.</source>
        <translation>Pas pendant une partie.</translation>
    </message>
    <message>
        <source>Only while a game is running.</source>
        <translation>Seulement pendant une partie.</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>Sélectionnez d’abord quelque chose.</translation>
    </message>
    <message>
        <source>Select at least two objects first.</source>
        <translation>Sélectionnez d’abord au moins deux objets.</translation>
    </message>
    <message>
        <source>Select nodes first, with the node tool.</source>
        <translation>Sélectionnez d’abord des nœuds avec l’outil Nœuds.</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>&amp;Grouper</translation>
    </message>
    <message>
        <source>Make one thing of what is selected; a double click gets at its parts</source>
        <translation>Réunir la sélection en un tout&#xa0;; un double-clic donne accès aux parties</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>&amp;Dégrouper</translation>
    </message>
    <message>
        <source>Take the selected groups apart</source>
        <translation>Défaire les groupes sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Mas&amp;quer</translation>
    </message>
    <message>
        <source>Show the selection no longer; it is played all the same</source>
        <translation>Ne plus afficher la sélection&#xa0;; elle reste jouée</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>&amp;Isoler</translation>
    </message>
    <message>
        <source>Hide everything but the selection</source>
        <translation>Masquer tout sauf la sélection</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>Tout &amp;afficher</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>Afficher tout ce qui est masqué</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>&amp;Verrouiller</translation>
    </message>
    <message>
        <source>Keep the selection from being selected, moved and removed</source>
        <translation>Empêcher de sélectionner, déplacer ou supprimer la sélection</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>Tout déverro&amp;uiller</translation>
    </message>
    <message>
        <source>Let everything that is locked be changed again</source>
        <translation>Permettre à nouveau de modifier tout ce qui est verrouillé</translation>
    </message>
    <message>
        <source>To &amp;Front</source>
        <translation>À l’&amp;avant</translation>
    </message>
    <message>
        <source>Draw the selection above everything</source>
        <translation>Dessiner la sélection au-dessus de tout</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>Draw the selection above the next object that overlaps it</source>
        <translation>Dessiner la sélection au-dessus du prochain objet qui la chevauche</translation>
    </message>
    <message>
        <source>&amp;Backward</source>
        <translation>&amp;Descendre</translation>
    </message>
    <message>
        <source>Draw the selection below the next object that overlaps it</source>
        <translation>Dessiner la sélection au-dessous du prochain objet qui la chevauche</translation>
    </message>
    <message>
        <source>To Ba&amp;ck</source>
        <translation>À l’a&amp;rrière</translation>
    </message>
    <message>
        <source>Draw the selection below everything</source>
        <translation>Dessiner la sélection au-dessous de tout</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>Bords &amp;gauches</translation>
    </message>
    <message>
        <source>Bring the left edges of the selected objects to that of the leftmost</source>
        <translation>Aligner les bords gauches des objets sélectionnés sur le plus à gauche</translation>
    </message>
    <message>
        <source>&amp;Centers on a Vertical Line</source>
        <translation>Centres sur une &amp;verticale</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects above each other</source>
        <translation>Placer les centres des objets sélectionnés les uns au-dessus des autres</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>Bords &amp;droits</translation>
    </message>
    <message>
        <source>Bring the right edges of the selected objects to that of the rightmost</source>
        <translation>Aligner les bords droits des objets sélectionnés sur le plus à droite</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>Bord&amp;s hauts</translation>
    </message>
    <message>
        <source>Bring the top edges of the selected objects to that of the highest</source>
        <translation>Aligner les bords supérieurs des objets sélectionnés sur le plus haut</translation>
    </message>
    <message>
        <source>C&amp;enters on a Horizontal Line</source>
        <translation>Centres sur une &amp;horizontale</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects beside each other</source>
        <translation>Placer les centres des objets sélectionnés les uns à côté des autres</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>Bords &amp;bas</translation>
    </message>
    <message>
        <source>Bring the bottom edges of the selected objects to that of the lowest</source>
        <translation>Aligner les bords inférieurs des objets sélectionnés sur le plus bas</translation>
    </message>
    <message>
        <source>Space Left Edges Evenly</source>
        <translation>Répartir les bords gauches</translation>
    </message>
    <message>
        <source>Distribute the left edges between those of the outermost objects</source>
        <translation>Répartir les bords gauches entre ceux des objets extrêmes</translation>
    </message>
    <message>
        <source>Space Centers Evenly Across</source>
        <translation>Répartir les centres en largeur</translation>
    </message>
    <message>
        <source>Distribute the centers from left to right</source>
        <translation>Répartir les centres de gauche à droite</translation>
    </message>
    <message>
        <source>Make &amp;Gaps Across Equal</source>
        <translation>Écarts égaux en &amp;largeur</translation>
    </message>
    <message>
        <source>Distribute the objects from left to right with the same gap between them</source>
        <translation>Répartir les objets de gauche à droite avec le même écart entre eux</translation>
    </message>
    <message>
        <source>Space Bottom Edges Evenly</source>
        <translation>Répartir les bords inférieurs</translation>
    </message>
    <message>
        <source>Distribute the bottom edges between those of the outermost objects</source>
        <translation>Répartir les bords inférieurs entre ceux des objets extrêmes</translation>
    </message>
    <message>
        <source>Space Centers Evenly Upwards</source>
        <translation>Répartir les centres en hauteur</translation>
    </message>
    <message>
        <source>Distribute the centers from bottom to top</source>
        <translation>Répartir les centres de bas en haut</translation>
    </message>
    <message>
        <source>Make Gaps &amp;Upwards Equal</source>
        <translation>Écarts égaux en ha&amp;uteur</translation>
    </message>
    <message>
        <source>Distribute the objects from bottom to top with the same gap between them</source>
        <translation>Répartir les objets de bas en haut avec le même écart entre eux</translation>
    </message>
    <message>
        <source>New &amp;Layer</source>
        <translation>&amp;Nouveau calque</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Above</source>
        <translation>Vers le &amp;calque au-dessus</translation>
    </message>
    <message>
        <source>Move the selection to the next higher layer</source>
        <translation>Déplacer la sélection vers le calque supérieur</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Below</source>
        <translation>Vers le ca&amp;lque au-dessous</translation>
    </message>
    <message>
        <source>Move the selection to the next lower layer, or out of all layers</source>
        <translation>Déplacer la sélection vers le calque inférieur, ou hors de tout calque</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>&amp;Union</translation>
    </message>
    <message>
        <source>Make one body of the selected polygons</source>
        <translation>Faire un seul corps des polygones sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>&amp;Différence</translation>
    </message>
    <message>
        <source>Cut the upper polygons out of the lowest one</source>
        <translation>Découper les polygones du dessus dans celui du dessous</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>&amp;Intersection</translation>
    </message>
    <message>
        <source>Keep what the selected polygons have in common</source>
        <translation>Garder ce que les polygones sélectionnés ont en commun</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Annuler la dernière modification</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>Il n’y a rien à annuler.</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>Refaire la modification</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>Il n’y a rien à rétablir.</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Co&amp;uper</translation>
    </message>
    <message>
        <source>Move the selection to the clipboard</source>
        <translation>Déplacer la sélection dans le presse-papiers</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>Copy the selection to the clipboard as text</source>
        <translation>Copier la sélection comme texte dans le presse-papiers</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>C&amp;oller</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard at the pointer</source>
        <translation>Insérer le contenu du presse-papiers au pointeur</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>Coller sur p&amp;lace</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard where it was copied</source>
        <translation>Insérer le contenu du presse-papiers là où il a été copié</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Copy the selection one grid step away</source>
        <translation>Copier la sélection à un pas de grille</translation>
    </message>
    <message>
        <source>Duplicat&amp;e in Place</source>
        <translation>Dupliquer sur plac&amp;e</translation>
    </message>
    <message>
        <source>Copy the selection onto itself; what is done to the copy can be repeated</source>
        <translation>Copier la sélection sur elle-même&#xa0;; ce que l’on fait à la copie peut être répété</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>Supprimer la sélection</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>Select every object</source>
        <translation>Sélectionner tous les objets</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>Désélectio&amp;nner</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Ne rien sélectionner</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>In&amp;verser la sélection</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>Sélectionner ce qui ne l’est pas</translation>
    </message>
    <message>
        <source>Select Same &amp;Kind</source>
        <translation>Sélectionner même t&amp;ype</translation>
    </message>
    <message>
        <source>Select all objects of the same kind as those selected</source>
        <translation>Sélectionner tous les objets du même type que la sélection</translation>
    </message>
    <message>
        <source>Select Same Ta&amp;gs</source>
        <translation>Mêmes éti&amp;quettes</translation>
    </message>
    <message>
        <source>Select all bodies with the same tags as those selected</source>
        <translation>Sélectionner tous les corps aux mêmes étiquettes que la sélection</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>Add an SVG drawing, a map of Tiled or a scene of R.U.B.E. to the level</source>
        <translation>Ajouter au niveau un dessin SVG, une carte de Tiled ou une scène de R.U.B.E.</translation>
    </message>
    <message>
        <source>&amp;Export As…</source>
        <translation>E&amp;xporter sous…</translation>
    </message>
    <message>
        <source>Write a picture of the level, as PNG or SVG</source>
        <translation>Écrire une image du niveau, en PNG ou SVG</translation>
    </message>
    <message>
        <source>E&amp;xport Again</source>
        <translation>Exporter à no&amp;uveau</translation>
    </message>
    <message>
        <source>Write the picture once more, to the same file in the same way</source>
        <translation>Écrire l’image encore une fois, de même et dans le même fichier</translation>
    </message>
    <message>
        <source>Screens&amp;hot</source>
        <translation>&amp;Capture d’écran</translation>
    </message>
    <message>
        <source>Write what the canvas shows to your pictures</source>
        <translation>Enregistrer ce que montre la zone de dessin dans vos images</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Nouveau</translation>
    </message>
    <message>
        <source>Start an empty level</source>
        <translation>Commencer un niveau vide</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a level file</source>
        <translation>Ouvrir un fichier de niveau</translation>
    </message>
    <message>
        <source>Reopen Closed &amp;Level</source>
        <translation>Rouvrir &amp;le niveau fermé</translation>
    </message>
    <message>
        <source>Open again the level that was closed last</source>
        <translation>Rouvrir le dernier niveau fermé</translation>
    </message>
    <message>
        <source>Q&amp;uick Open…</source>
        <translation>Ouverture &amp;rapide…</translation>
    </message>
    <message>
        <source>Find a level by a few letters of its name: recent ones, those beside it, and those that come with the program</source>
        <translation>Trouver un niveau par quelques lettres de son nom&#xa0;: les récents, leurs voisins et ceux fournis avec le programme</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Write the level to its file</source>
        <translation>Écrire le niveau dans son fichier</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Write the level to another file</source>
        <translation>Écrire le niveau dans un autre fichier</translation>
    </message>
    <message>
        <source>Reloa&amp;d</source>
        <translation>Rec&amp;harger</translation>
    </message>
    <message>
        <source>Read the level from its file again; Undo brings back what it is now</source>
        <translation>Relire le niveau depuis son fichier&#xa0;; Annuler ramène l’état actuel</translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Work…</source>
        <translation>Récu&amp;pérer le travail perdu…</translation>
    </message>
    <message>
        <source>Show what was left unsaved when the program ended all of a sudden</source>
        <translation>Afficher ce qui n’était pas enregistré quand le programme s’est arrêté brutalement</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Close this level and its window</source>
        <translation>Fermer ce niveau et sa fenêtre</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close all windows and leave the program</source>
        <translation>Fermer toutes les fenêtres et quitter le programme</translation>
    </message>
    <message>
        <source>&amp;Find Action…</source>
        <translation>Trouver une &amp;action…</translation>
    </message>
    <message>
        <source>Find actions, panels, levels, objects and problems by a few letters</source>
        <translation>Trouver actions, panneaux, niveaux, objets et problèmes par quelques lettres</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>&amp;Touches…</translation>
    </message>
    <message>
        <source>Show what the keys do</source>
        <translation>Afficher le rôle des touches</translation>
    </message>
    <message>
        <source>Keyboard &amp;Shortcuts…</source>
        <translation>&amp;Raccourcis clavier…</translation>
    </message>
    <message>
        <source>Give other keys to actions, or the keys of Tiled, Inkscape or Blender</source>
        <translation>Changer les touches des actions, ou prendre celles de Tiled, Inkscape ou Blender</translation>
    </message>
    <message>
        <source>&amp;About SpaceTow Studio…</source>
        <translation>À &amp;propos de SpaceTow Studio…</translation>
    </message>
    <message>
        <source>Show version and license</source>
        <translation>Afficher la version et la licence</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>Problème &amp;suivant</translation>
    </message>
    <message>
        <source>Go to the next problem of the level</source>
        <translation>Aller au problème suivant du niveau</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>Problème &amp;précédent</translation>
    </message>
    <message>
        <source>Go to the problem before</source>
        <translation>Aller au problème précédent</translation>
    </message>
    <message>
        <source>&amp;Fix Problem</source>
        <translation>C&amp;orriger le problème</translation>
    </message>
    <message>
        <source>Cure the problem that was gone to last, where there is a fix for it</source>
        <translation>Corriger le dernier problème visité, s’il existe une correction</translation>
    </message>
    <message>
        <source>Fix All &amp;Safe Problems</source>
        <translation>&amp;Tout corriger sans risque</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Corriger tous les problèmes dont la correction ne change rien de voulu</translation>
    </message>
    <message>
        <source>&amp;Hide Problem</source>
        <translation>&amp;Masquer le problème</translation>
    </message>
    <message>
        <source>Never show the problem that was gone to last in this level, or show it again</source>
        <translation>Ne plus afficher dans ce niveau le dernier problème visité, ou l’afficher de nouveau</translation>
    </message>
    <message>
        <source>Insert &amp;Midpoints</source>
        <translation>Insérer des &amp;milieux</translation>
    </message>
    <message>
        <source>Insert a node in the middle of each selected segment, or of all</source>
        <translation>Insérer un nœud au milieu de chaque segment sélectionné, ou de tous</translation>
    </message>
    <message>
        <source>D&amp;elete Segments</source>
        <translation>Supprimer les se&amp;gments</translation>
    </message>
    <message>
        <source>Remove the segments between selected nodes and leave the chain open there</source>
        <translation>Supprimer les segments entre les nœuds sélectionnés et y laisser la chaîne ouverte</translation>
    </message>
    <message>
        <source>Select two nodes next to each other first, with the node tool.</source>
        <translation>Sélectionnez d’abord deux nœuds voisins avec l’outil Nœuds.</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>&amp;Joindre les nœuds</translation>
    </message>
    <message>
        <source>Weld two end nodes, or two neighbours, into one in the middle</source>
        <translation>Souder deux nœuds d’extrémité, ou deux voisins, en un seul au milieu</translation>
    </message>
    <message>
        <source>Select two ends of walls or lines first, with the node tool.</source>
        <translation>Sélectionnez d’abord deux extrémités de murs ou de lignes avec l’outil Nœuds.</translation>
    </message>
    <message>
        <source>Join by a &amp;Segment</source>
        <translation>Joindre par un s&amp;egment</translation>
    </message>
    <message>
        <source>Join two end nodes by a new segment</source>
        <translation>Joindre deux nœuds d’extrémité par un nouveau segment</translation>
    </message>
    <message>
        <source>&amp;Break at Nodes</source>
        <translation>&amp;Briser aux nœuds</translation>
    </message>
    <message>
        <source>Split chains at the selected nodes, open closed ones</source>
        <translation>Couper les chaînes aux nœuds sélectionnés, ouvrir celles qui sont fermées</translation>
    </message>
    <message>
        <source>Make S&amp;traight in 15° Steps</source>
        <translation>&amp;Redresser par pas de 15°</translation>
    </message>
    <message>
        <source>Turn the selected segments to the nearest multiple of 15°</source>
        <translation>Tourner les segments sélectionnés au multiple de 15° le plus proche</translation>
    </message>
    <message>
        <source>&amp;Next Node</source>
        <translation>&amp;Nœud suivant</translation>
    </message>
    <message>
        <source>Select the next node</source>
        <translation>Sélectionner le nœud suivant</translation>
    </message>
    <message>
        <source>Take the node tool and select an object first.</source>
        <translation>Prenez d’abord l’outil Nœuds et sélectionnez un objet.</translation>
    </message>
    <message>
        <source>&amp;Previous Node</source>
        <translation>Nœud &amp;précédent</translation>
    </message>
    <message>
        <source>Select the previous node</source>
        <translation>Sélectionner le nœud précédent</translation>
    </message>
    <message>
        <source>Rotate &amp;Left 15°</source>
        <translation>Tourner à &amp;gauche de 15°</translation>
    </message>
    <message>
        <source>Turn the selection anticlockwise</source>
        <translation>Tourner la sélection dans le sens antihoraire</translation>
    </message>
    <message>
        <source>Rotate &amp;Right 15°</source>
        <translation>Tourner à &amp;droite de 15°</translation>
    </message>
    <message>
        <source>Turn the selection clockwise</source>
        <translation>Tourner la sélection dans le sens horaire</translation>
    </message>
    <message>
        <source>Rotate Left &amp;90°</source>
        <translation>Tourner à gauche de &amp;90°</translation>
    </message>
    <message>
        <source>Turn the selection a quarter anticlockwise</source>
        <translation>Tourner la sélection d’un quart de tour antihoraire</translation>
    </message>
    <message>
        <source>Rotate Right 9&amp;0°</source>
        <translation>Tourner à droite de 9&amp;0°</translation>
    </message>
    <message>
        <source>Turn the selection a quarter clockwise</source>
        <translation>Tourner la sélection d’un quart de tour horaire</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>Retourner &amp;horizontalement</translation>
    </message>
    <message>
        <source>Swap left and right; walls stay solid on the same side</source>
        <translation>Échanger gauche et droite&#xa0;; les murs restent solides du même côté</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>Retourner &amp;verticalement</translation>
    </message>
    <message>
        <source>Swap above and below; walls stay solid on the same side</source>
        <translation>Échanger haut et bas&#xa0;; les murs restent solides du même côté</translation>
    </message>
    <message>
        <source>Re&amp;peat Last Transform</source>
        <translation>&amp;Répéter la transformation</translation>
    </message>
    <message>
        <source>Move, turn, scale or copy the selection once more as it was done last</source>
        <translation>Déplacer, tourner, redimensionner ou copier la sélection encore une fois, comme la dernière fois</translation>
    </message>
    <message>
        <source>&amp;Type Place and Size…</source>
        <translation>Saisir &amp;position et taille…</translation>
    </message>
    <message>
        <source>Move, scale and turn the selection by numbers</source>
        <translation>Déplacer, redimensionner et tourner la sélection par des nombres</translation>
    </message>
    <message>
        <source>L&amp;inear Array…</source>
        <translation>Réseau &amp;linéaire…</translation>
    </message>
    <message>
        <source>Make copies of the selection in a row</source>
        <translation>Faire des copies de la sélection en ligne</translation>
    </message>
    <message>
        <source>R&amp;adial Array…</source>
        <translation>Réseau &amp;circulaire…</translation>
    </message>
    <message>
        <source>Make copies of the selection round its pivot</source>
        <translation>Faire des copies de la sélection autour de son pivot</translation>
    </message>
    <message>
        <source>Re&amp;verse Direction</source>
        <translation>Inverser le &amp;sens</translation>
    </message>
    <message>
        <source>Make one-way walls solid from the other side</source>
        <translation>Rendre les murs à sens unique solides de l’autre côté</translation>
    </message>
    <message>
        <source>&amp;Bounding Boxes</source>
        <translation>&amp;Boîtes englobantes</translation>
    </message>
    <message>
        <source>&amp;Incircles</source>
        <translation>C&amp;ercles inscrits</translation>
    </message>
    <message>
        <source>Show the incircle of every polygon</source>
        <translation>Afficher le cercle inscrit de chaque polygone</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>&amp;Vitesses</translation>
    </message>
    <message>
        <source>Show where every body would be in a second</source>
        <translation>Afficher où chaque corps serait dans une seconde</translation>
    </message>
    <message>
        <source>&amp;Orientations</source>
        <translation>O&amp;rientations</translation>
    </message>
    <message>
        <source>Show which way up every body is</source>
        <translation>Afficher où est le haut de chaque corps</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>&amp;Normales</translation>
    </message>
    <message>
        <source>&amp;All Off</source>
        <translation>&amp;Tout éteindre</translation>
    </message>
    <message>
        <source>Hide all overlays</source>
        <translation>Masquer les superpositions</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>Ét&amp;iquettes</translation>
    </message>
    <message>
        <source>Show names and colors of the tags of every object</source>
        <translation>Afficher noms et couleurs des étiquettes de chaque objet</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Problèmes</translation>
    </message>
    <message>
        <source>Mark the places of all problems of the level</source>
        <translation>Marquer le lieu de tous les problèmes du niveau</translation>
    </message>
    <message>
        <source>Sho&amp;w What Collides</source>
        <translation>Montrer les &amp;collisions</translation>
    </message>
    <message>
        <source>Mark everything that the selection would collide with, by its tags</source>
        <translation>Marquer tout ce que la sélection heurterait, d’après ses étiquettes</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>Rec&amp;hercher…</translation>
    </message>
    <message>
        <source>Find objects by name, kind or tag in the outliner</source>
        <translation>Trouver des objets par nom, type ou étiquette dans la structure</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>Reno&amp;mmer…</translation>
    </message>
    <message>
        <source>Give the selected object another name, in the outliner</source>
        <translation>Donner un autre nom à l’objet sélectionné, dans la structure</translation>
    </message>
    <message>
        <source>Level P&amp;roperties…</source>
        <translation>P&amp;ropriétés du niveau…</translation>
    </message>
    <message>
        <source>Edit the name, rules and physics of the level itself</source>
        <translation>Modifier le nom, les règles et la physique du niveau lui-même</translation>
    </message>
    <message>
        <source>Compare &amp;With…</source>
        <translation>Comparer a&amp;vec…</translation>
    </message>
    <message>
        <source>Choose a level file and show what is different from it</source>
        <translation>Choisir un fichier de niveau et afficher ce qui en diffère</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Jouer</translation>
    </message>
    <message>
        <source>Play a copy of the level, here and now</source>
        <translation>Jouer une copie du niveau, ici et maintenant</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>Pa&amp;use</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>&amp;Image suivante</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>&amp;Recommencer</translation>
    </message>
    <message>
        <source>&amp;Snap to Grid</source>
        <translation>Aimanter à la &amp;grille</translation>
    </message>
    <message>
        <source>Let points land on the grid; Ctrl suspends it while it is held</source>
        <translation>Poser les points sur la grille&#xa0;; Ctrl maintenu suspend l’aimantation</translation>
    </message>
    <message>
        <source>&amp;Coarser Grid</source>
        <translation>Grille plus &amp;large</translation>
    </message>
    <message>
        <source>Go on to the next larger step of the grid</source>
        <translation>Passer au pas de grille supérieur</translation>
    </message>
    <message>
        <source>&amp;Finer Grid</source>
        <translation>Grille plus &amp;fine</translation>
    </message>
    <message>
        <source>Go on to the next smaller step of the grid</source>
        <translation>Passer au pas de grille inférieur</translation>
    </message>
    <message>
        <source>Snap to &amp;Objects</source>
        <translation>Aimanter aux &amp;objets</translation>
    </message>
    <message>
        <source>Let points land on what is in the level; Ctrl suspends it while it is held</source>
        <translation>Poser les points sur ce qui est dans le niveau&#xa0;; Ctrl maintenu suspend l’aimantation</translation>
    </message>
    <message>
        <source>&amp;Vertices and Centers</source>
        <translation>&amp;Sommets et centres</translation>
    </message>
    <message>
        <source>Snap to the vertices of objects, and to the centers of circles</source>
        <translation>Aimanter aux sommets des objets et aux centres des cercles</translation>
    </message>
    <message>
        <source>Only while snapping to objects is on.</source>
        <translation>Seulement si l’aimantation aux objets est active.</translation>
    </message>
    <message>
        <source>&amp;Midpoints</source>
        <translation>&amp;Milieux</translation>
    </message>
    <message>
        <source>Snap to the middles of segments</source>
        <translation>Aimanter aux milieux des segments</translation>
    </message>
    <message>
        <source>&amp;Intersections</source>
        <translation>&amp;Intersections</translation>
    </message>
    <message>
        <source>Snap to where edges and guides cross</source>
        <translation>Aimanter là où arêtes et guides se croisent</translation>
    </message>
    <message>
        <source>&amp;Perpendiculars</source>
        <translation>Perpendi&amp;culaires</translation>
    </message>
    <message>
        <source>Snap to where the way from the last point meets an edge at a right angle</source>
        <translation>Aimanter là où le trajet depuis le dernier point rencontre une arête à angle droit</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>&amp;Arêtes</translation>
    </message>
    <message>
        <source>Snap to the edges of objects</source>
        <translation>Aimanter aux arêtes des objets</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>G&amp;uides</translation>
    </message>
    <message>
        <source>Snap to guides</source>
        <translation>Aimanter aux guides</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>Alig&amp;nement</translation>
    </message>
    <message>
        <source>Snap in line with the sides and middles of other objects</source>
        <translation>Aimanter dans l’alignement des côtés et milieux d’autres objets</translation>
    </message>
    <message>
        <source>A&amp;ngles</source>
        <translation>Angl&amp;es</translation>
    </message>
    <message>
        <source>Snap to multiples of 15° from the last point; Shift keeps to them always</source>
        <translation>Aimanter aux multiples de 15° depuis le dernier point&#xa0;; Maj les impose toujours</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>&amp;Sélection</translation>
    </message>
    <message>
        <source>Select and move objects</source>
        <translation>Sélectionner et déplacer des objets</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nœuds</translation>
    </message>
    <message>
        <source>Move, insert and delete the nodes of selected objects</source>
        <translation>Déplacer, insérer et supprimer les nœuds des objets sélectionnés</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>Co&amp;uteau</translation>
    </message>
    <message>
        <source>Cut walls, lines and polygons along a line</source>
        <translation>Couper murs, lignes et polygones le long d’une ligne</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>Mesu&amp;re</translation>
    </message>
    <message>
        <source>Measure lengths and angles</source>
        <translation>Mesurer longueurs et angles</translation>
    </message>
    <message>
        <source>One-Way &amp;Wall</source>
        <translation>&amp;Mur à sens unique</translation>
    </message>
    <message>
        <source>Draw walls that are solid from one side</source>
        <translation>Dessiner des murs solides d’un seul côté</translation>
    </message>
    <message>
        <source>Two-Way &amp;Line</source>
        <translation>&amp;Ligne à double sens</translation>
    </message>
    <message>
        <source>Draw walls that are solid from both sides</source>
        <translation>Dessiner des murs solides des deux côtés</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>&amp;Polygone</translation>
    </message>
    <message>
        <source>Draw a solid polygon</source>
        <translation>Dessiner un polygone plein</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>Rec&amp;tangle</translation>
    </message>
    <message>
        <source>Draw a solid rectangle</source>
        <translation>Dessiner un rectangle plein</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>&amp;Cercle</translation>
    </message>
    <message>
        <source>Draw a circle from its center</source>
        <translation>Dessiner un cercle depuis son centre</translation>
    </message>
    <message>
        <source>Moving &amp;Body</source>
        <translation>Corps m&amp;obile</translation>
    </message>
    <message>
        <source>Draw a body that moves as it is told, and its velocity</source>
        <translation>Dessiner un corps au mouvement imposé, et sa vitesse</translation>
    </message>
    <message>
        <source>C&amp;onnector</source>
        <translation>Connect&amp;eur</translation>
    </message>
    <message>
        <source>Join two bodies by a spring or rope</source>
        <translation>Joindre deux corps par un ressort ou une corde</translation>
    </message>
    <message>
        <source>S&amp;hip</source>
        <translation>&amp;Vaisseau</translation>
    </message>
    <message>
        <source>Place the ship; drag to turn it</source>
        <translation>Placer le vaisseau&#xa0;; glisser pour le tourner</translation>
    </message>
    <message>
        <source>Pa&amp;yload</source>
        <translation>C&amp;harge</translation>
    </message>
    <message>
        <source>Place the payload</source>
        <translation>Placer la charge</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>&amp;Arrivée</translation>
    </message>
    <message>
        <source>Draw the line that the payload has to cross</source>
        <translation>Dessiner la ligne que la charge doit franchir</translation>
    </message>
    <message>
        <source>Pl&amp;ace Ship, Payload, Finish</source>
        <translation>Placer va&amp;isseau, charge, arrivée</translation>
    </message>
    <message>
        <source>&amp;Guide…</source>
        <translation>&amp;Guide…</translation>
    </message>
    <message>
        <source>Add a guide at the pointer and type where it is</source>
        <translation>Ajouter un guide au pointeur et saisir sa position</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>&amp;Zoom avant</translation>
    </message>
    <message>
        <source>Show less of the level, larger</source>
        <translation>Afficher moins du niveau, en plus grand</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Zoom arr&amp;ière</translation>
    </message>
    <message>
        <source>Show more of the level, smaller</source>
        <translation>Afficher plus du niveau, en plus petit</translation>
    </message>
    <message>
        <source>Original Si&amp;ze</source>
        <translation>Taille &amp;originale</translation>
    </message>
    <message>
        <source>Show the level as large as in the game</source>
        <translation>Afficher le niveau à la taille du jeu</translation>
    </message>
    <message>
        <source>&amp;Fit Level</source>
        <translation>&amp;Niveau entier</translation>
    </message>
    <message>
        <source>Show the whole level</source>
        <translation>Afficher tout le niveau</translation>
    </message>
    <message>
        <source>&amp;Center Selection</source>
        <translation>&amp;Centrer la sélection</translation>
    </message>
    <message>
        <source>Bring the selection to the middle of the view</source>
        <translation>Amener la sélection au milieu de la vue</translation>
    </message>
    <message>
        <source>Fra&amp;me Selection</source>
        <translation>Ca&amp;drer la sélection</translation>
    </message>
    <message>
        <source>Show the selection as large as fits</source>
        <translation>Afficher la sélection aussi grande que possible</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>G&amp;rille</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>Afficher la grille</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>Règl&amp;es</translation>
    </message>
    <message>
        <source>Show the rulers, out of which guides are dragged</source>
        <translation>Afficher les règles, d’où l’on tire les guides</translation>
    </message>
    <message>
        <source>Guid&amp;es</source>
        <translation>G&amp;uides</translation>
    </message>
    <message>
        <source>Show the guides; what is hidden is neither taken nor snapped to</source>
        <translation>Afficher les guides&#xa0;; masqués, on ne peut ni les saisir ni s’y aimanter</translation>
    </message>
    <message>
        <source>&amp;Delete All Guides</source>
        <translation>&amp;Supprimer tous les guides</translation>
    </message>
    <message>
        <source>Take all guides out of the level</source>
        <translation>Retirer tous les guides du niveau</translation>
    </message>
    <message>
        <source>The level has no guides.</source>
        <translation>Le niveau n’a pas de guides.</translation>
    </message>
    <message>
        <source>Hide &amp;All</source>
        <translation>&amp;Tout masquer</translation>
    </message>
    <message>
        <source>Put all panels out of the way, and back as they were</source>
        <translation>Écarter tous les panneaux, ou les remettre comme avant</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>P&amp;lein écran</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Utiliser tout l’écran</translation>
    </message>
    <message>
        <source>Like &amp;the Desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is, and changing with it</source>
        <translation>Clair ou sombre comme le bureau, et changeant avec lui</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>Light panels and a white drawing board</source>
        <translation>Panneaux clairs et zone de dessin blanche</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>Dark panels and a drawing board as dark as space</source>
        <translation>Panneaux sombres et zone de dessin noire comme l’espace</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>Nouvelle &amp;fenêtre</translation>
    </message>
    <message>
        <source>Start an empty level in another window</source>
        <translation>Commencer un niveau vide dans une autre fenêtre</translation>
    </message>
    <message>
        <source>New &amp;View</source>
        <translation>Nouvelle &amp;vue</translation>
    </message>
    <message>
        <source>Show this level in a second window, at another place or another size</source>
        <translation>Afficher ce niveau dans une seconde fenêtre, ailleurs ou à une autre taille</translation>
    </message>
    <message>
        <source>&amp;Next Window</source>
        <translation>Fenêtre &amp;suivante</translation>
    </message>
    <message>
        <source>Go on in the next window of the program</source>
        <translation>Continuer dans la fenêtre suivante du programme</translation>
    </message>
    <message>
        <source>Welcome &amp;Page</source>
        <translation>Page d’&amp;accueil</translation>
    </message>
    <message>
        <source>Choose among recent levels and those that come with the program</source>
        <translation>Choisir parmi les niveaux récents et ceux fournis avec le programme</translation>
    </message>
    <message>
        <source>&amp;Reopen Windows at Start</source>
        <translation>&amp;Rouvrir les fenêtres au démarrage</translation>
    </message>
    <message>
        <source>Begin with the levels that were open when the program was left</source>
        <translation>Commencer avec les niveaux ouverts quand le programme a été quitté</translation>
    </message>
    <message>
        <source>Open a level first.</source>
        <translation>Ouvrez d’abord un niveau.</translation>
    </message>
    <message>
        <source>No level has been closed yet.</source>
        <translation>Aucun niveau n’a encore été fermé.</translation>
    </message>
    <message>
        <source>The level has no file yet.</source>
        <translation>Le niveau n’a pas encore de fichier.</translation>
    </message>
    <message>
        <source>Go to a problem first for which there is a fix.</source>
        <translation>Allez d’abord à un problème qui a un remède.</translation>
    </message>
    <message>
        <source>There is no problem that could be cured without asking.</source>
        <translation>Aucun problème ne peut être corrigé sans question.</translation>
    </message>
    <message>
        <source>Go to a problem first.</source>
        <translation>Allez d’abord à un problème.</translation>
    </message>
    <message>
        <source>The grid is as coarse as it gets.</source>
        <translation>La grille ne peut pas être plus large.</translation>
    </message>
    <message>
        <source>The grid is as fine as it gets.</source>
        <translation>La grille ne peut pas être plus fine.</translation>
    </message>
    <message>
        <source>This window stands alone.</source>
        <translation>Cette fenêtre est seule.</translation>
    </message>
    <message>
        <source>There is no other window.</source>
        <translation>Il n’y a pas d’autre fenêtre.</translation>
    </message>
    <message>
        <source>Show the bounding box of every body, and that of the broad phase</source>
        <translation>Afficher la boîte englobante de chaque corps, et celle de la phase large</translation>
    </message>
    <message>
        <source>Show the free side of every wall, and the solid band behind it</source>
        <translation>Afficher le côté libre de chaque mur, et la bande solide derrière lui</translation>
    </message>
    <message>
        <source>&amp;Quadtrees</source>
        <translation>Q&amp;uadtrees</translation>
    </message>
    <message>
        <source>Show the cells in which collisions are looked for, and what they hold</source>
        <translation>Afficher les cellules où les collisions sont cherchées, et ce qu’elles contiennent</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>C&amp;ontacts</translation>
    </message>
    <message>
        <source>Show where bodies touch, and the forces between them</source>
        <translation>Afficher où les corps se touchent, et les forces entre eux</translation>
    </message>
    <message>
        <source>T&amp;ension</source>
        <translation>&amp;Forces de tension</translation>
    </message>
    <message>
        <source>Show how much every rope and connector pulls</source>
        <translation>Afficher combien tire chaque corde et chaque connecteur</translation>
    </message>
    <message>
        <source>T&amp;rails</source>
        <translation>Tr&amp;aces</translation>
    </message>
    <message>
        <source>Show the way that every body has gone, or will go at first</source>
        <translation>Afficher le chemin que chaque corps a suivi, ou suivra au début</translation>
    </message>
    <message>
        <source>Centers of &amp;Mass</source>
        <translation>Centres de &amp;masse</translation>
    </message>
    <message>
        <source>Show the center of mass of every body</source>
        <translation>Afficher le centre de masse de chaque corps</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>Noms des objets</translation>
    </message>
    <message>
        <source>Show the name of every object that has one</source>
        <translation>Afficher le nom de chaque objet qui en a un</translation>
    </message>
    <message>
        <source>I&amp;slands and Sleep</source>
        <translation>Îlots et &amp;sommeil</translation>
    </message>
    <message>
        <source>Show which bodies may push each other, and which ones sleep</source>
        <translation>Afficher quels corps peuvent se pousser, et lesquels dorment</translation>
    </message>
    <message>
        <source>Ris&amp;k of Passing Through</source>
        <translation>Ris&amp;que de traversée</translation>
    </message>
    <message>
        <source>Show how far through each wall one iteration may carry what approaches it</source>
        <translation>Afficher jusqu’où, à travers chaque mur, une itération peut porter ce qui s’en approche</translation>
    </message>
    <message>
        <source>Reach o&amp;f the Ship</source>
        <translation>Portée &amp;du vaisseau</translation>
    </message>
    <message>
        <source>Show where the ship, and the payload on its rope, can be in the next seconds: from its start, or from where it is in a run that is paused</source>
        <translation>Afficher où le vaisseau, et la charge au bout de sa corde, peuvent être dans les prochaines secondes&#xa0;: depuis le départ, ou depuis leur place dans une exécution en pause</translation>
    </message>
    <message>
        <source>Reach a Second Longer</source>
        <translation>Allonger la portée d’une seconde</translation>
    </message>
    <message>
        <source>Look a second further ahead, up to five</source>
        <translation>Regarder une seconde plus loin, jusqu’à cinq</translation>
    </message>
    <message>
        <source>Reach a Second Shorter</source>
        <translation>Raccourcir la portée d’une seconde</translation>
    </message>
    <message>
        <source>Look less far ahead, down to one second</source>
        <translation>Regarder moins loin, jusqu’à une seule seconde</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>Lé&amp;gende</translation>
    </message>
    <message>
        <source>Explain the colors of the overlays that are on, in a corner of the canvas</source>
        <translation>Expliquer les couleurs des superpositions affichées, dans un coin de la zone de dessin</translation>
    </message>
    <message>
        <source>Color-Blind-Safe Colors</source>
        <translation>Couleurs pour daltoniens</translation>
    </message>
    <message>
        <source>Draw the overlays in the colors of Okabe and Ito, which everybody tells apart</source>
        <translation>Dessiner les superpositions dans les couleurs d’Okabe et Ito, que tout le monde distingue</translation>
    </message>
    <message>
        <source>Forget Own Colors</source>
        <translation>Oublier mes couleurs</translation>
    </message>
    <message>
        <source>Give all overlays the colors of the set again</source>
        <translation>Rendre à toutes les superpositions les couleurs du jeu de couleurs</translation>
    </message>
    <message>
        <source>No overlay has a color of your own: click one in the legend.</source>
        <translation>Aucune superposition n’a de couleur à vous&#xa0;: cliquez-en une dans la légende.</translation>
    </message>
    <message>
        <source>S&amp;imulate</source>
        <translation>&amp;Simuler</translation>
    </message>
    <message>
        <source>Let the bodies of the level move in place, and go on editing beside</source>
        <translation>Laisser bouger sur place les corps du niveau, tout en continuant à modifier</translation>
    </message>
    <message>
        <source>The level runs already.</source>
        <translation>Le niveau est déjà en cours d’exécution.</translation>
    </message>
    <message>
        <source>Play fr&amp;om Pointer</source>
        <translation>Jouer depuis le poin&amp;teur</translation>
    </message>
    <message>
        <source>Play a copy of the level in which the ship starts where the pointer is</source>
        <translation>Jouer une copie du niveau où le vaisseau part du pointeur</translation>
    </message>
    <message>
        <source>Go back to the drawing board</source>
        <translation>Revenir à la zone de dessin</translation>
    </message>
    <message>
        <source>Hold what runs, or let it go on</source>
        <translation>Suspendre l’exécution ou la reprendre</translation>
    </message>
    <message>
        <source>Hold what runs and advance it by one update</source>
        <translation>Suspendre l’exécution et l’avancer d’un pas</translation>
    </message>
    <message>
        <source>Run the level from its beginning</source>
        <translation>Exécuter le niveau depuis le début</translation>
    </message>
    <message>
        <source>Pre&amp;vious Frame</source>
        <translation>Image précé&amp;dente</translation>
    </message>
    <message>
        <source>Hold what runs and go back by one update</source>
        <translation>Suspendre l’exécution et la reculer d’un pas</translation>
    </message>
    <message>
        <source>Next I&amp;teration</source>
        <translation>Itérati&amp;on suivante</translation>
    </message>
    <message>
        <source>Hold what runs and look into the next update, one iteration further</source>
        <translation>Suspendre l’exécution et regarder dans le pas suivant, une itération plus loin</translation>
    </message>
    <message>
        <source>To the &amp;Beginning</source>
        <translation>Au dé&amp;but</translation>
    </message>
    <message>
        <source>Hold what runs and go back as far as it is kept</source>
        <translation>Suspendre l’exécution et revenir aussi loin qu’elle est conservée</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>Hold what runs and show its last moment</source>
        <translation>Suspendre l’exécution et montrer son dernier instant</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Plus l&amp;entement</translation>
    </message>
    <message>
        <source>Let time run half as fast; [ does so on the canvas</source>
        <translation>Ralentir le temps de moitié&#xa0;; [ le fait dans la zone de dessin</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>P&amp;lus vite</translation>
    </message>
    <message>
        <source>Let time run twice as fast; ] does so on the canvas</source>
        <translation>Faire passer le temps deux fois plus vite&#xa0;; ] le fait dans la zone de dessin</translation>
    </message>
    <message>
        <source>&amp;Follow the Ship</source>
        <translation>Suivre le &amp;vaisseau</translation>
    </message>
    <message>
        <source>Let the view go with the ship again, after it has been moved</source>
        <translation>La vue suit de nouveau le vaisseau, après avoir été déplacée</translation>
    </message>
    <message>
        <source>Only in a game is there a ship to follow.</source>
        <translation>Il n’y a de vaisseau à suivre que pendant une partie.</translation>
    </message>
    <message>
        <source>Save Fli&amp;ght…</source>
        <translation>Enre&amp;gistrer le vol…</translation>
    </message>
    <message>
        <source>Write what has been flown into a file that can be dropped on a window</source>
        <translation>Enregistrer ce qui a été volé dans un fichier qui peut être déposé sur une fenêtre</translation>
    </message>
    <message>
        <source>Copy &amp;Bug Capsule</source>
        <translation>Copier la capsule de &amp;bogue</translation>
    </message>
    <message>
        <source>Copy the level and the run up to this moment as text, for a mail or an issue; pasted into a window, it opens at the same moment</source>
        <translation>Copier le niveau et l’exécution jusqu’à ce moment sous forme de texte, pour un courriel ou un rapport de bogue ; collé dans une fenêtre, il s’ouvre au même moment</translation>
    </message>
    <message>
        <source>In a game only while its panels are shown.</source>
        <translation>Dans une partie, seulement tant que ses panneaux sont affichés.</translation>
    </message>
    <message>
        <source>Overlay Colors…</source>
        <translation>Couleurs des surimpressions…</translation>
    </message>
    <message>
        <source>Choose the set of colors of the overlays, and colors of your own for each</source>
        <translation>Choisir le jeu de couleurs des surimpressions, et vos propres couleurs pour chacune</translation>
    </message>
    <message>
        <source>Wa&amp;ys of a Run</source>
        <translation>Tra&amp;jets d’une exécution</translation>
    </message>
    <message>
        <source>Show the ways of the last minute where a run is held, and those of futures given up</source>
        <translation>Afficher les trajets de la dernière minute d’une exécution suspendue et ceux des futurs abandonnés</translation>
    </message>
    <message>
        <source>What is selected is locked.</source>
        <translation>La sélection est verrouillée.</translation>
    </message>
    <message>
        <source>Ship, payload and finish exist once, and connectors are copied with their two bodies.</source>
        <translation>Le vaisseau, la charge et l’arrivée n’existent qu’une fois, et les connecteurs sont copiés avec leurs deux corps.</translation>
    </message>
    <message>
        <source>Select a wall or a line first.</source>
        <translation>Sélectionnez d’abord un mur ou une ligne.</translation>
    </message>
    <message>
        <source>Select a group first.</source>
        <translation>Sélectionnez d’abord un groupe.</translation>
    </message>
    <message>
        <source>What is selected has no nodes.</source>
        <translation>La sélection n’a pas de nœuds.</translation>
    </message>
    <message>
        <source>“%1” changes nothing here.</source>
        <translation>« %1 » ne change rien ici.</translation>
    </message>
    <message>
        <source>Put the selection into a new layer, or make an empty one, and type its name</source>
        <translation>Mettre la sélection dans un nouveau calque, ou en créer un vide, et saisir son nom</translation>
    </message>
    <message>
        <source>Insert Node &amp;Here</source>
        <translation>Ins&amp;érer un nœud ici</translation>
    </message>
    <message>
        <source>Insert a node where the pointer is at an edge of the selection</source>
        <translation>Insérer un nœud là où le pointeur touche un bord de la sélection</translation>
    </message>
    <message>
        <source>Not while the level runs.</source>
        <translation>Pas pendant que le niveau tourne.</translation>
    </message>
    <message>
        <source>Place ship, payload or finish, first what the level lacks; again for the next of them</source>
        <translation>Placer le vaisseau, la charge ou l’arrivée, d’abord ce qui manque au niveau ; encore une fois pour le suivant</translation>
    </message>
</context>
<context>
    <name>BugCapsule</name>
    <message>
        <source>Another bug capsule is still being worked on.</source>
        <translation>Une autre capsule de bogue est encore en cours de traitement.</translation>
    </message>
    <message>
        <source>A bug capsule of %1 is on the clipboard. Paste it into a mail or an issue, or into a window of this program.</source>
        <translation>Une capsule de bogue de %1 est dans le presse-papiers. Collez-la dans un courriel, un rapport de bogue ou une fenêtre de ce programme.</translation>
    </message>
    <message>
        <source>The run comes out otherwise here than where the bug capsule was made, with %1 on %2.</source>
        <translation>L’exécution se déroule ici autrement que là où la capsule de bogue a été créée, avec %1 sous %2.</translation>
    </message>
    <message>
        <source>The bug capsule is being read…</source>
        <translation>La capsule de bogue est en cours de lecture…</translation>
    </message>
    <message>
        <source>The bug capsule</source>
        <translation>La capsule de bogue</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
</context>
<context>
    <name>Compared</name>
    <message>
        <source>none</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>all</source>
        <translation>tout</translation>
    </message>
    <message>
        <source>all but %1</source>
        <translation>tout sauf %1</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>Level: %1</source>
        <translation>Niveau&#xa0;: %1</translation>
    </message>
    <message>
        <source>Guide %1: added</source>
        <translation>Guide %1&#xa0;: ajouté</translation>
    </message>
    <message>
        <source>Guide %1: removed</source>
        <translation>Guide %1&#xa0;: supprimé</translation>
    </message>
    <message>
        <source>Level: fields that this program does not know</source>
        <translation>Niveau&#xa0;: champs que ce programme ne connaît pas</translation>
    </message>
    <message>
        <source>Level: other problems are hidden</source>
        <translation>Niveau&#xa0;: d’autres problèmes sont masqués</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Tag “%1”: added</source>
        <translation>Étiquette «&#xa0;%1&#xa0;»&#xa0;: ajoutée</translation>
    </message>
    <message>
        <source>Tag “%1”: removed</source>
        <translation>Étiquette «&#xa0;%1&#xa0;»&#xa0;: supprimée</translation>
    </message>
    <message>
        <source>Tag “%1”: renamed to “%2”</source>
        <translation>Étiquette «&#xa0;%1&#xa0;»&#xa0;: renommée en «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Tag “%1”: color %2 → %3</source>
        <translation>Étiquette «&#xa0;%1&#xa0;»&#xa0;: couleur %2 → %3</translation>
    </message>
    <message>
        <source>added</source>
        <translation>ajouté</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>supprimé</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>était %1</translation>
    </message>
    <message>
        <source>shape moved</source>
        <translation>forme déplacée</translation>
    </message>
    <message>
        <source>shape changed</source>
        <translation>forme modifiée</translation>
    </message>
    <message>
        <source>shape changed, points %1 → %2</source>
        <translation>forme modifiée, points %1 → %2</translation>
    </message>
    <message>
        <source>drawn in another place</source>
        <translation>dessiné à un autre rang</translation>
    </message>
    <message>
        <source>fields that this program does not know</source>
        <translation>champs que ce programme ne connaît pas</translation>
    </message>
    <message>
        <source>The level</source>
        <translation>Le niveau</translation>
    </message>
    <message>
        <source>%1: both sides changed “%2”.</source>
        <translation>%1&#xa0;: les deux côtés ont modifié «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>%1: both sides made something else of it.</source>
        <translation>%1&#xa0;: les deux côtés en ont fait autre chose.</translation>
    </message>
    <message>
        <source>%1: both sides added another object under the key %2.</source>
        <translation>%1&#xa0;: les deux côtés ont ajouté un autre objet sous la clé %2.</translation>
    </message>
    <message>
        <source>%1: our side removed it, their side changed or needs it. It stays.</source>
        <translation>%1&#xa0;: notre côté l’a supprimé, le leur l’a modifié ou en a besoin. Il reste.</translation>
    </message>
    <message>
        <source>%1: their side removed it, our side changed or needs it. It stays.</source>
        <translation>%1&#xa0;: leur côté l’a supprimé, le nôtre l’a modifié ou en a besoin. Il reste.</translation>
    </message>
    <message>
        <source>%1: groups would be in each other. It stays in the group that our side has put it in.</source>
        <translation>%1&#xa0;: des groupes seraient l’un dans l’autre. Il reste dans le groupe où notre côté l’a mis.</translation>
    </message>
    <message>
        <source>%1: both sides changed the order of drawing.</source>
        <translation>%1&#xa0;: les deux côtés ont modifié l’ordre de dessin.</translation>
    </message>
    <message>
        <source>There is no room for the tag “%1” of their side among the 32 tags.</source>
        <translation>Pas de place pour l’étiquette «&#xa0;%1&#xa0;» de leur côté parmi les 32 étiquettes.</translation>
    </message>
    <message>
        <source>Guides: in another order</source>
        <translation>Guides&#xa0;: dans un autre ordre</translation>
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
        <translation>Le vaisseau a heurté la charge.</translation>
    </message>
    <message>
        <source>The ship hit “%1”.</source>
        <translation>Le vaisseau a heurté « %1 ».</translation>
    </message>
    <message>
        <source>The payload hit “%1”.</source>
        <translation>La charge a heurté « %1 ».</translation>
    </message>
    <message>
        <source>The ship hit something tagged “%1”.</source>
        <translation>Le vaisseau a heurté quelque chose d’étiqueté « %1 ».</translation>
    </message>
    <message>
        <source>The payload hit something tagged “%1”.</source>
        <translation>La charge a heurté quelque chose d’étiqueté « %1 ».</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a flight in the level “%2”, which is neither open nor beside it. Open the level and drop the flight on it.</source>
        <translation>%1 est un vol dans le niveau «&#xa0;%2&#xa0;», qui n’est ni ouvert ni à côté. Ouvrez le niveau et déposez-y le vol.</translation>
    </message>
    <message>
        <source>The level has been changed since the flight was recorded, which may therefore end otherwise.</source>
        <translation>Le niveau a été modifié depuis l’enregistrement du vol, qui peut donc finir autrement.</translation>
    </message>
    <message>
        <source>Files of other programs are imported one at a time, as each is looked at first: of these it is %1.</source>
        <translation>Les fichiers d’autres programmes sont importés un par un, car chacun est d’abord examiné : parmi ceux-ci, c’est %1.</translation>
    </message>
    <message>
        <source>There is not enough memory to read the flight.</source>
        <translation>Il n’y a pas assez de mémoire pour lire le vol.</translation>
    </message>
    <message>
        <source>%1 is a simulation of the level “%2”, which is neither open nor beside it. Open the level and drop the simulation on it.</source>
        <translation>%1 est une simulation du niveau « %2 », qui n’est ni ouvert ni à côté. Ouvrez le niveau et déposez-y la simulation.</translation>
    </message>
    <message>
        <source>The level has been changed since the simulation was recorded, which may therefore go otherwise.</source>
        <translation>Le niveau a été modifié depuis l’enregistrement de la simulation, qui peut donc se dérouler autrement.</translation>
    </message>
</context>
<context>
    <name>Explain</name>
    <message>
        <source>Debris</source>
        <translation>Débris</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Forces</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Thrust and steering</source>
        <translation>Poussée et direction</translation>
    </message>
    <message>
        <source>Pulled by the mouse</source>
        <translation>Tiré par la souris</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Connecteurs</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>Total</translation>
    </message>
    <message>
        <source>felt, without a force</source>
        <translation>ressenti, sans force</translation>
    </message>
    <message>
        <source>%1, of which friction %2</source>
        <translation>%1, dont %2 de frottement</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Tags touched</source>
        <translation>Étiquettes touchées</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>Tourne</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>Énergie cinétique</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>Énergie potentielle</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Moment cinétique propre</translation>
    </message>
    <message>
        <source>Angular momentum</source>
        <translation>Moment cinétique</translation>
    </message>
    <message>
        <source>Sleeps</source>
        <translation>Dort</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Traction</translation>
    </message>
    <message>
        <source>Distance of its ends</source>
        <translation>Distance des bouts</translation>
    </message>
    <message>
        <source>Natural length</source>
        <translation>Longueur naturelle</translation>
    </message>
    <message>
        <source>Pushes with</source>
        <translation>Pousse avec</translation>
    </message>
    <message>
        <source>Pulls with</source>
        <translation>Tire avec</translation>
    </message>
    <message>
        <source>Elastic energy</source>
        <translation>Énergie élastique</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>Entre</translation>
    </message>
    <message>
        <source>All bodies</source>
        <translation>Tous les corps</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>Énergie totale</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>There is not enough memory to open the file.</source>
        <translation>Mémoire insuffisante pour ouvrir le fichier.</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>Lecture de %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>SpaceTow levels (*.json);;All files (*)</source>
        <translation>Niveaux SpaceTow (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Modifications non enregistrées</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Enregistrer «&#xa0;%1&#xa0;»&#xa0;?</translation>
    </message>
    <message>
        <source>If you discard them, they are lost.</source>
        <translation>Si vous les abandonnez, elles sont perdues.</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>A&amp;bandonner</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>The example</source>
        <translation>L’exemple</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
    <message>
        <source>Open level</source>
        <translation>Ouvrir un niveau</translation>
    </message>
    <message>
        <source>Save level as</source>
        <translation>Enregistrer sous</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Sans titre</translation>
    </message>
    <message>
        <source>level</source>
        <translation>niveau</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>Impossible d’ouvrir %1.</translation>
    </message>
    <message>
        <source>%1 was opened, but:</source>
        <translation>%1 est ouvert, mais&#xa0;:</translation>
    </message>
    <message>
        <source>Nothing is lost: your work is still here. Save it elsewhere?</source>
        <translation>Rien n’est perdu&#xa0;: votre travail est toujours ici. L’enregistrer ailleurs&#xa0;?</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>What was kept of %1 cannot be read.</source>
        <translation>Ce qui a été gardé de %1 est illisible.</translation>
    </message>
    <message>
        <source>Open Newest Backup</source>
        <translation>Ouvrir la sauvegarde</translation>
    </message>
    <message>
        <source>This is the newest backup of %1. The file stays as it is until you save.</source>
        <translation>Voici la dernière sauvegarde de %1. Le fichier reste tel quel jusqu’à l’enregistrement.</translation>
    </message>
    <message>
        <source>This backup cannot be opened.</source>
        <translation>Impossible d’ouvrir cette sauvegarde.</translation>
    </message>
    <message>
        <source>%1 is saved, but of the version before no backup could be made:</source>
        <translation>%1 est enregistré, mais aucune sauvegarde de la version précédente n’a pu être faite :</translation>
    </message>
    <message>
        <source>Compare with level</source>
        <translation>Comparer avec un niveau</translation>
    </message>
</context>
<context>
    <name>FlightFile</name>
    <message>
        <source>The flight has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>Le vol a été enregistré sous %1. Déposez le fichier sur une fenêtre pour le revoir.</translation>
    </message>
    <message>
        <source>The simulation has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>La simulation a été enregistrée sous %1. Déposez le fichier sur une fenêtre pour la revoir.</translation>
    </message>
    <message>
        <source>It ends after %1 of %2 updates: a file holds no more.</source>
        <translation>L’enregistrement finit après %1 mises à jour sur %2 : un fichier n’en contient pas plus.</translation>
    </message>
    <message>
        <source>Another recording is still being saved.</source>
        <translation>Un autre enregistrement est encore en cours de sauvegarde.</translation>
    </message>
</context>
<context>
    <name>FlightsPanel</name>
    <message>
        <source>wins after %1 s, with %2 s of thrust</source>
        <translation>gagne après %1 s, avec %2 s de poussée</translation>
    </message>
    <message>
        <source>is being flown…</source>
        <translation>est en vol…</translation>
    </message>
    <message>
        <source>still wins, after %1 s</source>
        <translation>gagne toujours, après %1 s</translation>
    </message>
    <message>
        <source>still wins, now after %1 s; before after %2 s</source>
        <translation>gagne toujours, maintenant après %1 s ; avant après %2 s</translation>
    </message>
    <message>
        <source>crashed before, wins now after %1 s</source>
        <translation>s’écrasait avant, gagne maintenant après %1 s</translation>
    </message>
    <message>
        <source>was not won before, wins now after %1 s</source>
        <translation>n’était pas gagné avant, gagne maintenant après %1 s</translation>
    </message>
    <message>
        <source>still crashes at %1, after %2 s</source>
        <translation>s’écrase toujours en %1, après %2 s</translation>
    </message>
    <message>
        <source>still crashes, now at %1, after %2 s; before after %3 s</source>
        <translation>s’écrase toujours, maintenant en %1, après %2 s ; avant après %3 s</translation>
    </message>
    <message>
        <source>won before, crashes now at %1, after %2 s</source>
        <translation>gagnait avant, s’écrase maintenant en %1, après %2 s</translation>
    </message>
    <message>
        <source>crashes now, at %1, after %2 s</source>
        <translation>s’écrase maintenant, en %1, après %2 s</translation>
    </message>
    <message>
        <source>crashes at %1, after %2 s</source>
        <translation>s’écrase en %1, après %2 s</translation>
    </message>
    <message>
        <source>won before, now there is no ship</source>
        <translation>gagnait avant, il n’y a maintenant plus de vaisseau</translation>
    </message>
    <message>
        <source>runs to its end</source>
        <translation>va jusqu’à sa fin</translation>
    </message>
    <message>
        <source>is still under way at its end, at %1</source>
        <translation>est toujours en route à sa fin, en %1</translation>
    </message>
    <message>
        <source>is still under way at its end, now at %1</source>
        <translation>est toujours en route à sa fin, maintenant en %1</translation>
    </message>
    <message>
        <source>won before, now is under way at its end, at %1</source>
        <translation>gagnait avant, est maintenant encore en route à sa fin, en %1</translation>
    </message>
    <message>
        <source>crashed before, now is under way at its end, at %1</source>
        <translation>s’écrasait avant, est maintenant encore en route à sa fin, en %1</translation>
    </message>
    <message>
        <source>is under way at its end, at %1</source>
        <translation>est encore en route à sa fin, en %1</translation>
    </message>
    <message>
        <source>cannot be flown: too many bodies lie in the same place. Move them apart.</source>
        <translation>ne peut pas être volé : trop de corps se trouvent au même endroit. Écartez-les.</translation>
    </message>
    <message>
        <source>is a simulation of %1 s</source>
        <translation>est une simulation de %1 s</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu : %1</translation>
    </message>
</context>
<context>
    <name>Forces</name>
    <message>
        <source>Gravity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>Appliquée</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Connecteurs</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
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
        <translation>Prêt</translation>
    </message>
    <message>
        <source>Press a direction to start</source>
        <translation>Appuyez sur une direction pour démarrer</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Écrasé</translation>
    </message>
    <message>
        <source>Press any key to try again</source>
        <translation>Appuyez sur une touche pour réessayer</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Fin de partie</translation>
    </message>
    <message>
        <source>No life is left. Press any key to start the level over</source>
        <translation>Plus de vies. Appuyez sur une touche pour recommencer le niveau</translation>
    </message>
    <message>
        <source>You made it!</source>
        <translation>Réussi&#xa0;!</translation>
    </message>
    <message>
        <source>Lives %1</source>
        <translation>Vies %1</translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation>Temps %1</translation>
    </message>
    <message>
        <source>Fuel used %1 s</source>
        <translation>Carburant %1 s</translation>
    </message>
    <message>
        <source>Gravity is upside down!</source>
        <translation>La gravité est inversée&#xa0;!</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>menu</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a key and what it does</comment>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>The payload is home.</source>
        <translation>La charge est à la maison.</translation>
    </message>
    <message>
        <source>fly again</source>
        <translation>voler encore</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>continuer</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>un pas</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>tow</source>
        <translation>remorquer</translation>
    </message>
    <message>
        <source>In range.</source>
        <translation>À portée.</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>tourner</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>poussée</translation>
    </message>
    <message>
        <source>Take the payload in tow and carry it across the finish.</source>
        <translation>Prenez la charge en remorque et portez-la au-delà de la ligne d’arrivée.</translation>
    </message>
    <message>
        <source>Ship and payload are lost.</source>
        <translation>Le vaisseau et la charge sont perdus.</translation>
    </message>
    <message>
        <source>The ship is lost.</source>
        <translation>Le vaisseau est perdu.</translation>
    </message>
    <message>
        <source>The payload is lost.</source>
        <translation>La charge est perdue.</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Static</source>
        <translation>Statique</translation>
    </message>
    <message>
        <source>Kinematic</source>
        <translation>Cinématique</translation>
    </message>
    <message>
        <source>Dynamic</source>
        <translation>Dynamique</translation>
    </message>
    <message>
        <source>No tension</source>
        <translation>Sans tension</translation>
    </message>
    <message>
        <source>Unlimited</source>
        <translation>Illimitée</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>Écrêtée</translation>
    </message>
    <message>
        <source>Tanh</source>
        <translation>Tanh</translation>
    </message>
    <message>
        <source>Partial tanh</source>
        <translation>Tanh partielle</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Général</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>Matière</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Connecteur</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisions</translation>
    </message>
    <message>
        <source>Rules of the game</source>
        <translation>Règles du jeu</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>Physique</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>For people; several objects may share one</source>
        <translation>Pour les humains&#xa0;; plusieurs objets peuvent le partager</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey forces</source>
        <translation>Les corps statiques ne bougent jamais, les cinématiques suivent leur consigne et rien ne les pousse, les dynamiques obéissent aux forces</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Name or key of the group that it is in; nothing for none</source>
        <translation>Nom ou clé du groupe qui le contient&#xa0;; rien si aucun</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Of the group&apos;s mark and of what is selected in it</source>
        <translation>De la marque du groupe et de ce qui y est sélectionné</translation>
    </message>
    <message>
        <source>Layer: a group at the top</source>
        <translation>Calque&#xa0;: un groupe à la racine</translation>
    </message>
    <message>
        <source>Visible in the editor</source>
        <translation>Visible dans l’éditeur</translation>
    </message>
    <message>
        <source>Locked: cannot be picked or moved</source>
        <translation>Verrouillé&#xa0;: ne peut être saisi ni déplacé</translation>
    </message>
    <message>
        <source>Where the origin of the object is</source>
        <translation>Où se trouve l’origine de l’objet</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Anticlockwise. Plain numbers are degrees; write “rad” after radians</source>
        <translation>Antihoraire. Un simple nombre est en degrés&#xa0;; ajoutez «&#xa0;rad&#xa0;» aux radians</translation>
    </message>
    <message>
        <source>From</source>
        <translation>De</translation>
    </message>
    <message>
        <source>One end of the finish</source>
        <translation>Une extrémité de l’arrivée</translation>
    </message>
    <message>
        <source>To</source>
        <translation>À</translation>
    </message>
    <message>
        <source>The other end of the finish</source>
        <translation>L’autre extrémité de l’arrivée</translation>
    </message>
    <message>
        <source>Center</source>
        <translation>Centre</translation>
    </message>
    <message>
        <source>Middle of the circle in the coordinates of its body</source>
        <translation>Centre du cercle dans les coordonnées de son corps</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>From the middle to the rim</source>
        <translation>Du centre au bord</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>How many corners the shape has; move them on the canvas</source>
        <translation>Nombre de coins de la forme&#xa0;; déplacez-les dans la zone de dessin</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>How far behind the line counts as inside the wall; nothing for a wall without a back</source>
        <translation>Jusqu’où, derrière la ligne, on est dans le mur&#xa0;; rien pour un mur sans dos</translation>
    </message>
    <message>
        <source>no back</source>
        <translation>sans dos</translation>
    </message>
    <message>
        <source>Closed: the last point joins the first</source>
        <translation>Fermé&#xa0;: le dernier point rejoint le premier</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Nothing: area times density</source>
        <translation>Rien&#xa0;: aire fois densité</translation>
    </message>
    <message>
        <source>from shape</source>
        <translation>d’après la forme</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Densité</translation>
    </message>
    <message>
        <source>Counts while no mass is given; a metre of wall weighs 1 kg times the density</source>
        <translation>Vaut si aucune masse n’est donnée&#xa0;; un mètre de mur pèse 1 kg fois la densité</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>Restitution</translation>
    </message>
    <message>
        <source>Share of the speed that is left after a bounce</source>
        <translation>Part de la vitesse qui reste après un rebond</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Coefficient of friction: force along a surface per force on it</source>
        <translation>Coefficient de frottement&#xa0;: force le long d’une surface par force qui la presse</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Of the center of mass at the start</source>
        <translation>Du centre de masse au départ</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Turning at the start, anticlockwise</source>
        <translation>Vitesse de rotation au départ, antihoraire</translation>
    </message>
    <message>
        <source>Linear damping</source>
        <translation>Amortissement linéaire</translation>
    </message>
    <message>
        <source>Share of the velocity that is lost each second</source>
        <translation>Part de la vitesse perdue chaque seconde</translation>
    </message>
    <message>
        <source>Angular damping</source>
        <translation>Amortissement angulaire</translation>
    </message>
    <message>
        <source>Share of the spin that is lost each second</source>
        <translation>Part de la rotation perdue chaque seconde</translation>
    </message>
    <message>
        <source>Frozen: held in place</source>
        <translation>Figé&#xa0;: maintenu en place</translation>
    </message>
    <message>
        <source>First body</source>
        <translation>Premier corps</translation>
    </message>
    <message>
        <source>Name or key of the body that it holds</source>
        <translation>Nom ou clé du corps qu’il tient</translation>
    </message>
    <message>
        <source>Second body</source>
        <translation>Second corps</translation>
    </message>
    <message>
        <source>Name or key of the other body that it holds</source>
        <translation>Nom ou clé de l’autre corps qu’il tient</translation>
    </message>
    <message>
        <source>Anchor on first</source>
        <translation>Ancrage au premier</translation>
    </message>
    <message>
        <source>Where it holds the first body, in the coordinates of that</source>
        <translation>Où il tient le premier corps, dans les coordonnées de celui-ci</translation>
    </message>
    <message>
        <source>Anchor on second</source>
        <translation>Ancrage au second</translation>
    </message>
    <message>
        <source>Where it holds the second body, in the coordinates of that</source>
        <translation>Où il tient le second corps, dans les coordonnées de celui-ci</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>At which it neither pulls nor pushes; nothing: the distance at the start</source>
        <translation>À laquelle il ne tire ni ne pousse&#xa0;; rien&#xa0;: la distance au départ</translation>
    </message>
    <message>
        <source>as placed</source>
        <translation>comme placé</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Force per metre of stretch</source>
        <translation>Force par mètre d’allongement</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>Force against the speed of stretching</source>
        <translation>Force contre la vitesse d’allongement</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Tension</translation>
    </message>
    <message>
        <source>How the force of the spring is limited</source>
        <translation>Comment la force du ressort est limitée</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Limite</translation>
    </message>
    <message>
        <source>Most tension, where it is limited</source>
        <translation>Tension maximale, si elle est limitée</translation>
    </message>
    <message>
        <source>Untouched part</source>
        <translation>Part intacte</translation>
    </message>
    <message>
        <source>Share of the limit below which “partial tanh” changes nothing</source>
        <translation>Part de la limite sous laquelle «&#xa0;tanh partielle&#xa0;» ne change rien</translation>
    </message>
    <message>
        <source>Slack: pulls only</source>
        <translation>Lâche&#xa0;: tire seulement</translation>
    </message>
    <message>
        <source>Its two bodies may collide</source>
        <translation>Ses deux corps peuvent se heurter</translation>
    </message>
    <message>
        <source>Tangible: others bounce off it</source>
        <translation>Tangible&#xa0;: les autres y rebondissent</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Est</translation>
    </message>
    <message>
        <source>Tags that say what it is</source>
        <translation>Étiquettes qui disent ce que c’est</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Touche</translation>
    </message>
    <message>
        <source>Two bodies meet when each touches a tag that the other has</source>
        <translation>Deux corps se rencontrent si chacun touche une étiquette que l’autre porte</translation>
    </message>
    <message>
        <source>Of the level, as players see it</source>
        <translation>Du niveau, tel que les joueurs le voient</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Auteur</translation>
    </message>
    <message>
        <source>Who made it</source>
        <translation>Qui l’a fait</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Description</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>Fond</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>Vies</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Essais</translation>
    </message>
    <message>
        <source>Tow range</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>Greatest distance of ship and payload at which the rope can be attached</source>
        <translation>Plus grande distance entre vaisseau et charge où la corde s’attache</translation>
    </message>
    <message>
        <source>Towing turns gravity round</source>
        <translation>Remorquer inverse la gravité</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Acceleration of everything that falls</source>
        <translation>Accélération de tout ce qui tombe</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>Time that one update simulates</source>
        <translation>Temps que simule un pas</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Passes of motion and collision in one update; more are more exact and slower</source>
        <translation>Passes de mouvement et de collision par pas&#xa0;; plus il y en a, plus c’est exact et lent</translation>
    </message>
    <message>
        <source>Sub-steps</source>
        <translation>Sous-pas</translation>
    </message>
    <message>
        <source>Steps of motion in one iteration</source>
        <translation>Pas de mouvement par itération</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Vaisseau</translation>
    </message>
    <message>
        <source>Tow rope</source>
        <translation>Corde de remorquage</translation>
    </message>
    <message>
        <source>Bodies at rest sleep</source>
        <translation>Corps au repos endormis</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Force along the nose of the ship</source>
        <translation>Force dans l’axe du nez du vaisseau</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>How fast the ship begins to turn while a direction is held</source>
        <translation>À quelle vitesse le vaisseau se met à tourner tant qu’une direction est maintenue</translation>
    </message>
    <message>
        <source>Of the ship alone</source>
        <translation>Du vaisseau seul</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Of the rectangle, along its own side; the middle stays where it is</source>
        <translation>Du rectangle, le long de son propre côté ; le milieu reste où il est</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
</context>
<context>
    <name>KeyFileTexts</name>
    <message>
        <source>“%1” needs a list of keys, as in [&quot;Ctrl+S&quot;].</source>
        <translation>«&#xa0;%1&#xa0;» demande une liste de touches, comme [&quot;Ctrl+S&quot;].</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no key.</source>
        <translation>«&#xa0;%1&#xa0;» de «&#xa0;%2&#xa0;» n’est pas une touche.</translation>
    </message>
    <message>
        <source>%1 is given to “%2” and to “%3”.</source>
        <translation>%1 est attribué à «&#xa0;%2&#xa0;» et à «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2.</source>
        <translation>La ligne %1 n’est pas du JSON&#xa0;: %2.</translation>
    </message>
    <message>
        <source>These keys were written by a newer version of the program.</source>
        <translation>Ces touches viennent d’une version plus récente du programme.</translation>
    </message>
    <message>
        <source>There are no keys in it; it should look like {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</source>
        <translation>Aucune touche dedans&#xa0;; cela devrait ressembler à {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</translation>
    </message>
</context>
<context>
    <name>KeyTexts</name>
    <message>
        <source>That is no single key.</source>
        <translation>Ce n’est pas une seule touche.</translation>
    </message>
    <message>
        <source>%1 belongs to the drawing board and cannot be given away.</source>
        <translation>%1 sert à la zone de dessin et ne peut être attribué.</translation>
    </message>
    <message>
        <source>%1 goes from field to field and cannot be given away.</source>
        <translation>%1 passe de champ en champ et ne peut être attribué.</translation>
    </message>
    <message>
        <source>“%1” works while a game is running too, when plain keys are the game&apos;s: use Ctrl, Alt or a function key with it.</source>
        <translation>«&#xa0;%1&#xa0;» agit aussi pendant une partie, où les touches seules sont au jeu&#xa0;: ajoutez Ctrl, Alt ou prenez une touche de fonction.</translation>
    </message>
    <message>
        <source>In the game</source>
        <translation>Dans le jeu</translation>
    </message>
    <message>
        <source>%1 cannot be a key of the game: choose one without Ctrl and Alt that is no function key.</source>
        <translation>%1 ne peut pas être une touche du jeu : choisissez-en une sans Ctrl ni Alt qui ne soit pas une touche de fonction.</translation>
    </message>
    <message>
        <source>%1 always shows the menu of the game.</source>
        <translation>%1 montre toujours le menu du jeu.</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Click · Shift or Ctrl + click</source>
        <translation>Clic · Maj ou Ctrl + clic</translation>
    </message>
    <message>
        <source>Select · add to the selection or take from it</source>
        <translation>Sélectionner · ajouter à la sélection ou en retirer</translation>
    </message>
    <message>
        <source>Drag on empty space</source>
        <translation>Glisser dans le vide</translation>
    </message>
    <message>
        <source>Select with a rubber band; Alt or B: only what lies wholly inside</source>
        <translation>Sélectionner par un cadre&#xa0;; Alt ou B&#xa0;: seulement ce qui est tout entier dedans</translation>
    </message>
    <message>
        <source>Alt + click · B + click</source>
        <translation>Alt + clic · B + clic</translation>
    </message>
    <message>
        <source>Select the next object underneath; a right click lists them all</source>
        <translation>Sélectionner l’objet du dessous&#xa0;; un clic droit les liste tous</translation>
    </message>
    <message>
        <source>Alt + drag · B + drag</source>
        <translation>Alt + glisser · B + glisser</translation>
    </message>
    <message>
        <source>Move the selection from anywhere</source>
        <translation>Déplacer la sélection de n’importe où</translation>
    </message>
    <message>
        <source>Enter or right click</source>
        <translation>Entrée ou clic droit</translation>
    </message>
    <message>
        <source>End the shape that is being drawn</source>
        <translation>Finir la forme en cours</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Take back the last point</source>
        <translation>Retirer le dernier point</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Cancel: gesture, shape, selection, tool</source>
        <translation>Annuler&#xa0;: geste, forme, sélection, outil</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>Move the selection a little; Shift: a grid step; Alt: a pixel</source>
        <translation>Déplacer un peu la sélection&#xa0;; Maj&#xa0;: un pas de grille&#xa0;; Alt&#xa0;: un pixel</translation>
    </message>
    <message>
        <source>Wheel · pinch</source>
        <translation>Molette · pincement</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Zoomer au pointeur</translation>
    </message>
    <message>
        <source>Middle or right drag · Space + drag · two fingers</source>
        <translation>Glisser du bouton central ou droit · Espace + glisser · deux doigts</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Déplacer la vue</translation>
    </message>
    <message>
        <source>On the drawing board</source>
        <translation>Dans la zone de dessin</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Tow the payload when it is near; again: let it go</source>
        <translation>Remorquer la charge proche&#xa0;; encore&#xa0;: la lâcher</translation>
    </message>
    <message>
        <source>Hold the game and show the menu</source>
        <translation>Suspendre la partie et afficher le menu</translation>
    </message>
    <message>
        <source>Let the view follow the ship again</source>
        <translation>La vue suit de nouveau le vaisseau</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>Tourner à gauche</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Tourner à droite</translation>
    </message>
    <message>
        <source>Hold the game, or go on</source>
        <translation>Mettre le jeu en pause, ou continuer</translation>
    </message>
    <message>
        <source>Hold the game and advance it by one update</source>
        <translation>Mettre le jeu en pause et l’avancer d’un pas</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Recommencer le niveau</translation>
    </message>
    <message>
        <source>Let time run slower</source>
        <translation>Faire passer le temps plus lentement</translation>
    </message>
    <message>
        <source>Let time run faster</source>
        <translation>Faire passer le temps plus vite</translation>
    </message>
    <message>
        <source>While held: one update back</source>
        <translation>En pause&#xa0;: un pas en arrière</translation>
    </message>
    <message>
        <source>While held: one update on</source>
        <translation>En pause&#xa0;: un pas en avant</translation>
    </message>
    <message>
        <source>Turn time back, as long as the key is held</source>
        <translation>Remonter le temps tant que la touche est maintenue</translation>
    </message>
    <message>
        <source>Shift · Ctrl while moving or drawing</source>
        <translation>Maj · Ctrl en déplaçant ou dessinant</translation>
    </message>
    <message>
        <source>Keep to an axis or to steps of 15° · switch snapping off or on for the moment</source>
        <translation>Rester sur un axe ou par pas de 15° · couper ou activer le magnétisme un instant</translation>
    </message>
    <message>
        <source>Shift · Ctrl while drawing a rectangle</source>
        <translation>Maj · Ctrl en dessinant un rectangle</translation>
    </message>
    <message>
        <source>From its middle · a square</source>
        <translation>Depuis son milieu · un carré</translation>
    </message>
    <message>
        <source>Shift · Ctrl · Alt while scaling</source>
        <translation>Maj · Ctrl · Alt en redimensionnant</translation>
    </message>
    <message>
        <source>About the middle · keep the proportions · switch snapping off or on</source>
        <translation>Autour du milieu · garder les proportions · couper ou activer le magnétisme</translation>
    </message>
    <message>
        <source>Shift · Ctrl while turning</source>
        <translation>Maj · Ctrl en tournant</translation>
    </message>
    <message>
        <source>About the opposite corner · in steps of 15°</source>
        <translation>Autour du coin opposé · par pas de 15°</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Bounding box</source>
        <translation>Boîte englobante</translation>
    </message>
    <message>
        <source>Box of the broad phase, with room to move</source>
        <translation>Boîte de la phase large, avec marge de mouvement</translation>
    </message>
    <message>
        <source>Largest circle about the centroid</source>
        <translation>Plus grand cercle autour du centroïde</translation>
    </message>
    <message>
        <source>Way of the next second</source>
        <translation>Chemin de la prochaine seconde</translation>
    </message>
    <message>
        <source>Up, 1 m</source>
        <translation>Haut, 1 m</translation>
    </message>
    <message>
        <source>Free side, 1 m</source>
        <translation>Côté libre, 1 m</translation>
    </message>
    <message>
        <source>Solid band behind the wall</source>
        <translation>Bande solide derrière le mur</translation>
    </message>
    <message>
        <source>Cell of what stands still</source>
        <translation>Cellule de ce qui est immobile</translation>
    </message>
    <message>
        <source>Cell of what moves</source>
        <translation>Cellule de ce qui bouge</translation>
    </message>
    <message>
        <source>Point of contact</source>
        <translation>Point de contact</translation>
    </message>
    <message>
        <source>Near, not touching yet</source>
        <translation>Proche, sans contact encore</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normale</translation>
    </message>
    <message>
        <source>Pressed to half its length</source>
        <translation>Comprimé à la moitié de sa longueur</translation>
    </message>
    <message>
        <source>At its natural length</source>
        <translation>Longueur naturelle</translation>
    </message>
    <message>
        <source>Stretched by half its length</source>
        <translation>Étiré à une fois et demie</translation>
    </message>
    <message>
        <source>Way, older ones fainter</source>
        <translation>Chemin, de plus en plus pâle avec l’âge</translation>
    </message>
    <message>
        <source>Center of mass and axes</source>
        <translation>Centre de masse et axes</translation>
    </message>
    <message>
        <source>Name of the object</source>
        <translation>Nom de l’objet</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Endormi</translation>
    </message>
    <message>
        <source>Deep enough for what comes</source>
        <translation>Assez profond pour ce qui arrive</translation>
    </message>
    <message>
        <source>Passed through in one iteration</source>
        <translation>Traversé en une itération</translation>
    </message>
    <message>
        <source>The selection collides with it</source>
        <translation>La sélection le heurte</translation>
    </message>
    <message>
        <source>The selection passes through</source>
        <translation>La sélection le traverse</translation>
    </message>
    <message>
        <source>One color an island</source>
        <translation>Une couleur par îlot</translation>
    </message>
    <message>
        <source>The color of the first tag; a dot for each further one</source>
        <translation>La couleur de la première étiquette&#xa0;; un point pour chaque autre</translation>
    </message>
    <message>
        <source>Force; 1 m is the weight of the lighter one, 2 m ten times as much</source>
        <translation>Force ; 1 m vaut le poids du plus léger, 2 m dix fois plus</translation>
    </message>
    <message>
        <source>Way in the time that is kept</source>
        <translation>Trajet dans le temps conservé</translation>
    </message>
    <message>
        <source>Way in a future given up, dashed</source>
        <translation>Trajet dans un futur abandonné, en tirets</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>One-way wall</source>
        <translation>Mur à sens unique</translation>
    </message>
    <message>
        <source>Two-way line</source>
        <translation>Ligne à double sens</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>Polygone</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>Corps</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>Vaisseau</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Arrivée</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>Connecteur</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Calque</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 at %2; %3</source>
        <translation>%1 à %2&#xa0;; %3</translation>
    </message>
</context>
<context>
    <name>ObjectFilter</name>
    <message>
        <source>wall</source>
        <translation>mur</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ligne</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>polygone</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>cercle</translation>
    </message>
    <message>
        <source>static</source>
        <translation>statique</translation>
    </message>
    <message>
        <source>kinematic</source>
        <translation>cinématique</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>dynamique</translation>
    </message>
    <message>
        <source>ship</source>
        <translation>vaisseau</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>charge</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>arrivée</translation>
    </message>
    <message>
        <source>connector</source>
        <translation>connecteur</translation>
    </message>
    <message>
        <source>group</source>
        <translation>groupe</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>calque</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>masqué</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>&amp;Inspector</source>
        <translation>&amp;Inspecteur</translation>
    </message>
    <message>
        <source>&amp;Outliner</source>
        <translation>&amp;Structure</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>&amp;Problèmes</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>&amp;Nœuds</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>&amp;Historique</translation>
    </message>
    <message>
        <source>&amp;Minimap</source>
        <translation>Mini-&amp;carte</translation>
    </message>
    <message>
        <source>&amp;Level Properties</source>
        <translation>Propriétés du ni&amp;veau</translation>
    </message>
    <message>
        <source>&amp;Tag Matrix</source>
        <translation>&amp;Matrice</translation>
    </message>
    <message>
        <source>&amp;Differences</source>
        <translation>&amp;Différences</translation>
    </message>
    <message>
        <source>Show or hide this panel</source>
        <translation>Afficher ou masquer ce panneau</translation>
    </message>
    <message>
        <source>&amp;Flights</source>
        <translation>V&amp;ols</translation>
    </message>
    <message>
        <source>&amp;Run Changes</source>
        <translation>Modifications en cou&amp;rs d’exécution</translation>
    </message>
    <message>
        <source>E&amp;xplain</source>
        <translation>E&amp;xplication</translation>
    </message>
    <message>
        <source>Plot&amp;s</source>
        <translation>Cour&amp;bes</translation>
    </message>
    <message>
        <source>Profil&amp;e</source>
        <translation>Pro&amp;fil</translation>
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
        <translation>angle</translation>
    </message>
    <message>
        <source>velocity to the right</source>
        <translation>vitesse vers la droite</translation>
    </message>
    <message>
        <source>velocity upwards</source>
        <translation>vitesse vers le haut</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>angular velocity</source>
        <translation>vitesse angulaire</translation>
    </message>
    <message>
        <source>force to the right</source>
        <translation>force vers la droite</translation>
    </message>
    <message>
        <source>force upwards</source>
        <translation>force vers le haut</translation>
    </message>
    <message>
        <source>force of contacts</source>
        <translation>force des contacts</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>énergie cinétique</translation>
    </message>
    <message>
        <source>potential energy</source>
        <translation>énergie potentielle</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>énergie</translation>
    </message>
    <message>
        <source>momentum to the right</source>
        <translation>quantité de mouvement vers la droite</translation>
    </message>
    <message>
        <source>momentum upwards</source>
        <translation>quantité de mouvement vers le haut</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>moment cinétique</translation>
    </message>
    <message>
        <source>length</source>
        <translation>longueur</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>tension</translation>
    </message>
    <message>
        <source>elastic energy</source>
        <translation>énergie élastique</translation>
    </message>
    <message>
        <source>energy of everything</source>
        <translation>énergie de l’ensemble</translation>
    </message>
    <message>
        <source>kinetic energy of everything</source>
        <translation>énergie cinétique de l’ensemble</translation>
    </message>
    <message>
        <source>potential energy of everything</source>
        <translation>énergie potentielle de l’ensemble</translation>
    </message>
    <message>
        <source>elastic energy of everything</source>
        <translation>énergie élastique de l’ensemble</translation>
    </message>
    <message>
        <source>drift of energy</source>
        <translation>dérive de l’énergie</translation>
    </message>
    <message>
        <source>momentum of everything to the right</source>
        <translation>quantité de mouvement de l’ensemble vers la droite</translation>
    </message>
    <message>
        <source>momentum of everything upwards</source>
        <translation>quantité de mouvement de l’ensemble vers le haut</translation>
    </message>
    <message>
        <source>drift of momentum</source>
        <translation>dérive de la quantité de mouvement</translation>
    </message>
    <message>
        <source>angular momentum of everything</source>
        <translation>moment cinétique de l’ensemble</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Modifications</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Mouvement</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>Paires</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Time of impact</source>
        <translation>Instant d’impact</translation>
    </message>
    <message>
        <source>Crushing</source>
        <translation>Écrasement</translation>
    </message>
    <message>
        <source>Advance</source>
        <translation>Avancement</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>Touchers</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>Sommeil</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ProfilePanel</name>
    <message>
        <source>Static bodies</source>
        <translation>Corps statiques</translation>
    </message>
    <message>
        <source>Kinematic bodies</source>
        <translation>Corps cinématiques</translation>
    </message>
    <message>
        <source>Dynamic bodies</source>
        <translation>Corps dynamiques</translation>
    </message>
    <message>
        <source>Awake</source>
        <translation>Éveillés</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>Endormi</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>Connecteurs</translation>
    </message>
    <message>
        <source>Pairs that may meet</source>
        <translation>Paires pouvant se rencontrer</translation>
    </message>
    <message>
        <source>Pairs that touch</source>
        <translation>Paires en contact</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>Îlots</translation>
    </message>
    <message>
        <source>Leaves of the quadtrees</source>
        <translation>Feuilles des quadtrees</translation>
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
        <translation>Maj</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page préc.</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page suiv.</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
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
        <translation>Une étiquette de ce nom existe déjà.</translation>
    </message>
    <message>
        <source>That is how a tag without a name is written.</source>
        <translation>C’est ainsi que s’écrit une étiquette sans nom.</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.</source>
        <translation>Dessinez des niveaux et volez-y&#xa0;: éditeur de niveaux et bac à sable physique.</translation>
    </message>
    <message>
        <source>Level files to open; without any, what was open last.</source>
        <translation>Fichiers de niveau à ouvrir&#xa0;; sans aucun, ce qui était ouvert en dernier.</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The file declares entities of its own (line %1), which are not read because they can be made to grow without end. Save it as plain SVG, for example with Inkscape, and try again.</source>
        <translation>Le fichier déclare ses propres entités (ligne %1), qui ne sont pas lues car elles peuvent grossir sans fin. Enregistrez-le en SVG simple, par exemple avec Inkscape, et réessayez.</translation>
    </message>
    <message>
        <source>The import was stopped; nothing was changed.</source>
        <translation>L’import a été arrêté&#xa0;; rien n’a changé.</translation>
    </message>
    <message>
        <source>The file is compressed. Unpack it first, or save it as plain SVG instead of SVGZ.</source>
        <translation>Le fichier est compressé. Décompressez-le d’abord, ou enregistrez-le en SVG simple et non en SVGZ.</translation>
    </message>
    <message>
        <source>This is no file that can be imported: SVG drawings, maps of Tiled (.tmx, .tmj) and scenes of R.U.B.E. (.json) can.</source>
        <translation>Ce fichier ne peut pas être importé&#xa0;: le peuvent les dessins SVG, les cartes de Tiled (.tmx, .tmj) et les scènes de R.U.B.E. (.json).</translation>
    </message>
    <message>
        <source>This is a level already: open it instead of importing it.</source>
        <translation>C’est déjà un niveau&#xa0;: ouvrez-le au lieu de l’importer.</translation>
    </message>
    <message>
        <source>This is a tileset or a template of Tiled, which draws nothing. Import a map.</source>
        <translation>C’est un jeu de tuiles ou un modèle de Tiled, qui ne dessine rien. Importez une carte.</translation>
    </message>
    <message>
        <source>At this scale something would lie more than %1 m away. Choose a smaller scale.</source>
        <translation>À cette échelle, quelque chose serait à plus de %1 m. Choisissez une échelle plus petite.</translation>
    </message>
    <message>
        <source>The result would have more than %1 vertices. Choose a larger tolerance.</source>
        <translation>Le résultat aurait plus de %1 sommets. Choisissez une tolérance plus grande.</translation>
    </message>
    <message>
        <source>There is nothing in this file that could become part of a level.</source>
        <translation>Rien dans ce fichier ne peut devenir une part de niveau.</translation>
    </message>
    <message>
        <source>Text was left out (%4). Turn it into paths to have it.</source>
        <translation>Du texte a été omis (%4). Convertissez-le en chemins pour l’avoir.</translation>
    </message>
    <message>
        <source>Pictures were left out (%4).</source>
        <translation>Des images ont été omises (%4).</translation>
    </message>
    <message>
        <source>Content in another language than SVG was left out (%4).</source>
        <translation>Du contenu dans un autre langage que SVG a été omis (%4).</translation>
    </message>
    <message>
        <source>Animations were left out (%4).</source>
        <translation>Des animations ont été omises (%4).</translation>
    </message>
    <message>
        <source>Scripts were left out (%4).</source>
        <translation>Des scripts ont été omis (%4).</translation>
    </message>
    <message>
        <source>Some selectors of a style sheet are not understood (%4): what they say of fill and stroke was not taken over.</source>
        <translation>Des sélecteurs d’une feuille de style ne sont pas compris (%4)&#xa0;: leur remplissage et leur contour n’ont pas été repris.</translation>
    </message>
    <message>
        <source>What is not displayed was left out (%4).</source>
        <translation>Ce qui n’est pas affiché a été omis (%4).</translation>
    </message>
    <message>
        <source>Shapes without fill and stroke were left out (%4).</source>
        <translation>Des formes sans remplissage ni contour ont été omises (%4).</translation>
    </message>
    <message>
        <source>A transform is not understood and was left out (%4).</source>
        <translation>Une transformation incomprise a été omise (%4).</translation>
    </message>
    <message>
        <source>Clips and masks were not applied: shapes are there as a whole (%4).</source>
        <translation>Découpes et masques n’ont pas été appliqués&#xa0;: les formes sont entières (%4).</translation>
    </message>
    <message>
        <source>Filters were not applied (%4).</source>
        <translation>Des filtres n’ont pas été appliqués (%4).</translation>
    </message>
    <message>
        <source>References to what is not in the file, or to themselves, were left out (%4): %3</source>
        <translation>Des références hors du fichier, ou à elles-mêmes, ont été omises (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>The data of shapes has a mistake; they are there up to it (%4).</source>
        <translation>Les données de formes ont une erreur&#xa0;; elles sont reprises jusque-là (%4).</translation>
    </message>
    <message>
        <source>Shapes without any extent were left out (%4).</source>
        <translation>Des formes sans étendue ont été omises (%4).</translation>
    </message>
    <message>
        <source>Areas with holes, or in several parts, were cut into several polygons (%4).</source>
        <translation>Des surfaces trouées ou en plusieurs parts ont été découpées en plusieurs polygones (%4).</translation>
    </message>
    <message>
        <source>Polygons of more than 1024 vertices became walls (%4). A larger tolerance makes fewer vertices.</source>
        <translation>Des polygones de plus de 1024 sommets sont devenus des murs (%4). Une tolérance plus grande donne moins de sommets.</translation>
    </message>
    <message>
        <source>Areas that cross themselves very often became walls (%4).</source>
        <translation>Des surfaces qui se croisent très souvent sont devenues des murs (%4).</translation>
    </message>
    <message>
        <source>Layers of tiles were left out, for a level has no tiles: %3 (%4). Objects of object layers are taken over.</source>
        <translation>Des calques de tuiles ont été omis, car un niveau n’a pas de tuiles&#xa0;: %3 (%4). Les objets des calques d’objets sont repris.</translation>
    </message>
    <message>
        <source>Layers of pictures were left out: %3 (%4).</source>
        <translation>Des calques d’images ont été omis&#xa0;: %3 (%4).</translation>
    </message>
    <message>
        <source>Tilesets are not needed and were not read: %3.</source>
        <translation>Les jeux de tuiles sont inutiles et n’ont pas été lus&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Objects that are tiles were left out (%4).</source>
        <translation>Des objets qui sont des tuiles ont été omis (%4).</translation>
    </message>
    <message>
        <source>Objects made of templates were left out, for these are in other files (%4). Detach them in Tiled.</source>
        <translation>Des objets tirés de modèles ont été omis, car ceux-ci sont dans d’autres fichiers (%4). Détachez-les dans Tiled.</translation>
    </message>
    <message>
        <source>Objects of a form that is not known here were left out (%4).</source>
        <translation>Des objets d’une forme inconnue ici ont été omis (%4).</translation>
    </message>
    <message>
        <source>Points were left out (%4): only those of the class “ship” or “payload” become something.</source>
        <translation>Des points ont été omis (%4)&#xa0;: seuls ceux de la classe «&#xa0;ship&#xa0;» ou «&#xa0;payload&#xa0;» deviennent quelque chose.</translation>
    </message>
    <message>
        <source>Properties that mean nothing here were left out (%4): %3.</source>
        <translation>Des propriétés sans effet ici ont été omises (%4)&#xa0;: %3.</translation>
    </message>
    <message>
        <source>The opacity of layers was not taken over: %3 (%4).</source>
        <translation>L’opacité des calques n’a pas été reprise&#xa0;: %3 (%4).</translation>
    </message>
    <message>
        <source>The parallax of layers was not taken over: %3 (%4).</source>
        <translation>La parallaxe des calques n’a pas été reprise&#xa0;: %3 (%4).</translation>
    </message>
    <message>
        <source>Gravity was not taken over (%4): the level keeps its own.</source>
        <translation>La gravité n’a pas été reprise (%4)&#xa0;: le niveau garde la sienne.</translation>
    </message>
    <message>
        <source>Numbers that a level cannot have were brought into its range (%4): %3.</source>
        <translation>Des nombres impossibles dans un niveau ont été ramenés dans ses limites (%4)&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Fixtures without a sound shape were left out (%4).</source>
        <translation>Des fixtures sans forme correcte ont été omises (%4).</translation>
    </message>
    <message>
        <source>Group indices of filters were not taken over (%4): %3</source>
        <translation>Les indices de groupe des filtres n’ont pas été repris (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Fixtures of one body differ in material or filter: those of the first were taken (%4): %3</source>
        <translation>Les fixtures d’un même corps diffèrent en matière ou filtre&#xa0;: ceux de la première ont été pris (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Sensors of bodies that also have solid fixtures were left out (%4): %3</source>
        <translation>Les capteurs de corps ayant aussi des fixtures solides ont été omis (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Settings of bodies that mean nothing here were left out (%4): %3</source>
        <translation>Des réglages de corps sans effet ici ont été omis (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Bodies without fixtures were left out (%4): %3</source>
        <translation>Des corps sans fixture ont été omis (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Joints that no connector can be were left out (%4): %3</source>
        <translation>Des articulations qu’aucun connecteur ne peut rendre ont été omises (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>Rigid joints became stiff connectors (%4): %3</source>
        <translation>Des articulations rigides sont devenues des connecteurs raides (%4)&#xa0;: %3</translation>
    </message>
    <message>
        <source>The level has a ship, a payload or a finish already; those of the file were left out.</source>
        <translation>Le niveau a déjà un vaisseau, une charge ou une arrivée&#xa0;; ceux du fichier ont été omis.</translation>
    </message>
    <message>
        <source>All 32 tags are taken; these were left out: %3</source>
        <translation>Les 32 étiquettes sont prises&#xa0;; celles-ci ont été omises&#xa0;: %3</translation>
    </message>
    <message>
        <source>One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what comes from the left of the drawing direction is stopped</source>
        <translation>Mur à sens unique · clic&#xa0;: premier point · glisser&#xa0;: premier segment · Ctrl&#xa0;: aimant non/oui · ce qui vient de la gauche du sens de dessin est arrêté</translation>
    </message>
    <message>
        <source>Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Points&#xa0;: %1 · clic&#xa0;: ajouter · clic sur le premier point&#xa0;: fermer · Entrée ou clic droit&#xa0;: finir · Retour arrière&#xa0;: retirer le point · chiffres&#xa0;: saisir longueur et angle · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · longueur %2 m, angle %3°</translation>
    </message>
    <message>
        <source>Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel</source>
        <translation>Points&#xa0;: %1 · clic&#xa0;: fermer la chaîne · Entrée ou clic droit&#xa0;: la laisser ouverte · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>A chain of walls needs two points: click to add another, or Escape to cancel</source>
        <translation>Une chaîne de murs demande deux points&#xa0;: cliquez pour en ajouter un, ou Échap pour annuler</translation>
    </message>
    <message>
        <source>This is where the last point is already: move on before you click</source>
        <translation>Le dernier point est déjà ici&#xa0;: éloignez-vous avant de cliquer</translation>
    </message>
    <message>
        <source>Click or drag: go on with this chain, which keeps its direction · Alt or B + click: begin a chain of its own here</source>
        <translation>Clic ou glisser&#xa0;: continuer cette chaîne, qui garde son sens · Alt ou B + clic&#xa0;: commencer ici une nouvelle chaîne</translation>
    </message>
    <message>
        <source>Click: close the chain at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Clic&#xa0;: fermer la chaîne à son autre bout · Entrée ou clic droit&#xa0;: la laisser ouverte · Échap&#xa0;: la laisser telle qu’elle était</translation>
    </message>
    <message>
        <source>Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on</source>
        <translation>Ligne à double sens · clic&#xa0;: premier point · glisser&#xa0;: premier segment · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>Click or drag: go on with this line · Alt or B + click: begin a line of its own here</source>
        <translation>Clic ou glisser&#xa0;: continuer cette ligne · Alt ou B + clic&#xa0;: commencer ici une nouvelle ligne</translation>
    </message>
    <message>
        <source>Click: close the line at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>Clic&#xa0;: fermer la ligne à son autre bout · Entrée ou clic droit&#xa0;: la laisser ouverte · Échap&#xa0;: la laisser telle qu’elle était</translation>
    </message>
    <message>
        <source>Polygon · click: first corner · drag: first side · Ctrl: snap off/on</source>
        <translation>Polygone · clic&#xa0;: premier coin · glisser&#xa0;: premier côté · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>Corners: %1 · click: add · click the first corner, Enter or right click: close · Backspace: undo corner · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>Coins&#xa0;: %1 · clic&#xa0;: ajouter · clic sur le premier coin, Entrée ou clic droit&#xa0;: fermer · Retour arrière&#xa0;: retirer le coin · chiffres&#xa0;: saisir longueur et angle · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · longueur %2 m, angle %3°</translation>
    </message>
    <message>
        <source>Corners: %1 · click: close the polygon · Escape: cancel</source>
        <translation>Coins&#xa0;: %1 · clic&#xa0;: fermer le polygone · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>A polygon needs three corners: click to add another, or Escape to cancel</source>
        <translation>Un polygone demande trois coins&#xa0;: cliquez pour en ajouter un, ou Échap pour annuler</translation>
    </message>
    <message>
        <source>This is where the last corner is already: move on before you click</source>
        <translation>Le dernier coin est déjà ici&#xa0;: éloignez-vous avant de cliquer</translation>
    </message>
    <message>
        <source>This side would run through another one, and a polygon must not cross itself · move on before you click</source>
        <translation>Ce côté en traverserait un autre, et un polygone ne doit pas se croiser · éloignez-vous avant de cliquer</translation>
    </message>
    <message>
        <source>The polygon crosses itself where it is marked and cannot be finished like this · Backspace: undo corner</source>
        <translation>Le polygone se croise là où c’est marqué et ne peut pas finir ainsi · Retour arrière&#xa0;: retirer le coin</translation>
    </message>
    <message>
        <source>Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on</source>
        <translation>Fermé ici, le polygone se croiserait · Retour arrière&#xa0;: retirer le coin · clic&#xa0;: continuer</translation>
    </message>
    <message>
        <source>All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner</source>
        <translation>Tous les coins sont alignés&#xa0;: un polygone demande un intérieur · clic&#xa0;: ajouter un coin · Retour arrière&#xa0;: retirer le coin</translation>
    </message>
    <message>
        <source>Rectangle · drag from corner to corner, or click both, or click one and type the size · Shift: from the middle · Ctrl: square</source>
        <translation>Rectangle · glisser de coin à coin, ou cliquer les deux, ou en cliquer un et saisir la taille · Maj&#xa0;: depuis le milieu · Ctrl&#xa0;: carré</translation>
    </message>
    <message>
        <source>Width %1 m, height %2 m · click or release: done · Shift: from the middle · Ctrl: square · Alt or B: snap off/on · Escape: cancel</source>
        <translation>Largeur %1 m, hauteur %2 m · clic ou relâcher&#xa0;: fini · Maj&#xa0;: depuis le milieu · Ctrl&#xa0;: carré · Alt ou B&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>A rectangle needs width and height: move on before you click or release</source>
        <translation>Un rectangle demande largeur et hauteur&#xa0;: éloignez-vous avant de cliquer ou relâcher</translation>
    </message>
    <message>
        <source>Moving body · drag: rectangle · click: first corner of a polygon · then its velocity · Shift: from the middle · Ctrl: square</source>
        <translation>Corps mobile · glisser&#xa0;: rectangle · clic&#xa0;: premier coin d’un polygone · puis sa vitesse · Maj&#xa0;: depuis le milieu · Ctrl&#xa0;: carré</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · click or drag: set it · digits: type it · Shift: 15° · Ctrl: snap off/on · Enter, right click or Escape: leave the body at rest</source>
        <translation>Vitesse %1 m/s, %2° · clic ou glisser&#xa0;: la fixer · chiffres&#xa0;: la saisir · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · Entrée, clic droit ou Échap&#xa0;: laisser le corps au repos</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · Shift: 15° · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Vitesse %1 m/s, %2° · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · relâcher&#xa0;: fini · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Drag: change the velocity of this body, a metre for each m/s</source>
        <translation>Glisser&#xa0;: changer la vitesse de ce corps, un mètre par m/s</translation>
    </message>
    <message>
        <source>Connector · drag from one body to another, or click both · anchors snap to nodes, middles and the grid</source>
        <translation>Connecteur · glisser d’un corps à l’autre, ou cliquer les deux · les ancrages s’aimantent aux nœuds, milieux et à la grille</translation>
    </message>
    <message>
        <source>Drag or click: connect “%1” with another body</source>
        <translation>Glisser ou clic&#xa0;: relier «&#xa0;%1&#xa0;» à un autre corps</translation>
    </message>
    <message>
        <source>Drag or click: connect this fixed body with another one</source>
        <translation>Glisser ou clic&#xa0;: relier ce corps fixe à un autre</translation>
    </message>
    <message>
        <source>Drag or click: connect this moving body with another one</source>
        <translation>Glisser ou clic&#xa0;: relier ce corps mobile à un autre</translation>
    </message>
    <message>
        <source>Drag or click: connect this loose body with another one</source>
        <translation>Glisser ou clic&#xa0;: relier ce corps libre à un autre</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with “%2” · Escape: cancel</source>
        <translation>Longueur %1 m · relâcher ou clic&#xa0;: relier à «&#xa0;%2&#xa0;» · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this fixed body · Escape: cancel</source>
        <translation>Longueur %1 m · relâcher ou clic&#xa0;: relier à ce corps fixe · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this moving body · Escape: cancel</source>
        <translation>Longueur %1 m · relâcher ou clic&#xa0;: relier à ce corps mobile · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this loose body · Escape: cancel</source>
        <translation>Longueur %1 m · relâcher ou clic&#xa0;: relier à ce corps libre · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Neither of these two bodies can be moved by a connector, one should be dynamic · release or click: connect them all the same · length %1 m</source>
        <translation>Aucun de ces deux corps ne peut être mû par un connecteur, l’un devrait être dynamique · relâcher ou clic&#xa0;: les relier quand même · longueur %1 m</translation>
    </message>
    <message>
        <source>This is the body where the connector begins: it needs another one</source>
        <translation>C’est le corps où commence le connecteur&#xa0;: il en faut un autre</translation>
    </message>
    <message>
        <source>Connectors join bodies; ship, payload and finish are none</source>
        <translation>Les connecteurs relient des corps&#xa0;; vaisseau, charge et arrivée n’en sont pas</translation>
    </message>
    <message>
        <source>There is no body here: a connector leads from one body to another</source>
        <translation>Aucun corps ici&#xa0;: un connecteur va d’un corps à un autre</translation>
    </message>
    <message>
        <source>There was no body where the drag began: press on one, then drag to another</source>
        <translation>Aucun corps là où le geste a commencé&#xa0;: appuyez sur un corps, puis glissez vers un autre</translation>
    </message>
    <message>
        <source>Nothing was connected: release the button over another body</source>
        <translation>Rien n’a été relié&#xa0;: relâchez le bouton sur un autre corps</translation>
    </message>
    <message>
        <source>Length and angle · Tab: the other one · an empty one is left to the pointer · Enter or click: place the point · Escape: back to the pointer</source>
        <translation>Longueur et angle · Tab&#xa0;: l’autre champ · un champ vide suit le pointeur · Entrée ou clic&#xa0;: placer le point · Échap&#xa0;: revenir au pointeur</translation>
    </message>
    <message>
        <source>Speed and direction · Tab: the other one · an empty one is left to the pointer · Enter or click: set the velocity · Escape: back to the pointer</source>
        <translation>Vitesse et direction · Tab&#xa0;: l’autre champ · un champ vide suit le pointeur · Entrée ou clic&#xa0;: fixer la vitesse · Échap&#xa0;: revenir au pointeur</translation>
    </message>
    <message>
        <source>Width and height · Tab: the other one · an empty one is left to the pointer · Enter or click: draw the rectangle · Escape: back to the pointer</source>
        <translation>Largeur et hauteur · Tab&#xa0;: l’autre champ · un champ vide suit le pointeur · Entrée ou clic&#xa0;: dessiner le rectangle · Échap&#xa0;: revenir au pointeur</translation>
    </message>
    <message>
        <source>Radius · Enter or click: draw the circle · Escape: back to the pointer</source>
        <translation>Rayon · Entrée ou clic&#xa0;: dessiner le cercle · Échap&#xa0;: revenir au pointeur</translation>
    </message>
    <message>
        <source>“%1” is no number in metres: type one such as 2.5, 80 cm or 3/4</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre en mètres&#xa0;: saisissez par exemple 2.5, 80 cm ou 3/4</translation>
    </message>
    <message>
        <source>“%1” is no angle: type degrees such as 45, −22.5 or 180/7, anticlockwise from the right</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un angle&#xa0;: saisissez des degrés comme 45, −22.5 ou 180/7, antihoraire depuis la droite</translation>
    </message>
    <message>
        <source>“%1” is too small: a size must be more than nothing</source>
        <translation>«&#xa0;%1&#xa0;» est trop petit&#xa0;: une taille doit être plus que rien</translation>
    </message>
    <message>
        <source>Circle · drag from the center, or click it and then click or type the radius · Ctrl: snap off/on</source>
        <translation>Cercle · glisser depuis le centre, ou le cliquer puis cliquer ou saisir le rayon · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Rayon %1 m · clic ou relâcher&#xa0;: fini · Ctrl&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>A circle needs a radius: move away from the center before you click</source>
        <translation>Un cercle demande un rayon&#xa0;: éloignez-vous du centre avant de cliquer</translation>
    </message>
    <message>
        <source>Guide · drag: move it · drag onto a ruler: delete it · double click: type place, angle and name</source>
        <translation>Guide · glisser&#xa0;: le déplacer · glisser sur une règle&#xa0;: le supprimer · double-clic&#xa0;: saisir position, angle et nom</translation>
    </message>
    <message>
        <source>New guide at %1 m, %2 m · release: done · Ctrl: snap off/on · back onto the ruler or Escape: none</source>
        <translation>Nouveau guide à %1 m, %2 m · relâcher&#xa0;: fini · Ctrl&#xa0;: aimant non/oui · retour sur la règle ou Échap&#xa0;: aucun</translation>
    </message>
    <message>
        <source>New guide · drag it into the drawing board · Escape: none</source>
        <translation>Nouveau guide · le glisser dans la zone de dessin · Échap&#xa0;: aucun</translation>
    </message>
    <message>
        <source>Guide at %1 m, %2 m, %3° · release: done · Shift: turn · Ctrl: snap off/on · onto a ruler: delete · Escape: cancel</source>
        <translation>Guide à %1 m, %2 m, %3° · relâcher&#xa0;: fini · Maj&#xa0;: tourner · Ctrl&#xa0;: aimant non/oui · sur une règle&#xa0;: supprimer · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Guide on the ruler · release: delete it · Escape: cancel</source>
        <translation>Guide sur la règle · relâcher&#xa0;: le supprimer · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Measure · drag from one point to the other, or click both · Ctrl: snap off/on</source>
        <translation>Mesure · glisser d’un point à l’autre, ou cliquer les deux · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click or release: done · Shift: 15° · Ctrl: snap off/on · Escape: clear</source>
        <translation>%1 m, en largeur %2 m, en hauteur %3 m, %4° · clic ou relâcher&#xa0;: fini · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>First point · click the other one · Escape: clear</source>
        <translation>Premier point · cliquer l’autre · Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, en largeur %2 m, en hauteur %3 m, %4° · Ctrl+C&#xa0;: copier · glisser&#xa0;: mesurer de nouveau · Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click: angle %5° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m, en largeur %2 m, en hauteur %3 m, %4° · clic&#xa0;: angle %5° · Ctrl+C&#xa0;: copier · glisser&#xa0;: mesurer de nouveau · Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>Angle %1° between %2 m and %3 m · Ctrl+C: copy · click or drag: measure anew · Escape: clear</source>
        <translation>Angle %1° entre %2 m et %3 m · Ctrl+C&#xa0;: copier · clic ou glisser&#xa0;: mesurer de nouveau · Échap&#xa0;: effacer</translation>
    </message>
    <message>
        <source>Nodes · click a wall, line, polygon or finish to edit its nodes</source>
        <translation>Nœuds · cliquer un mur, une ligne, un polygone ou l’arrivée pour en modifier les nœuds</translation>
    </message>
    <message>
        <source>What is selected has no nodes · click a wall, line, polygon or finish to edit it</source>
        <translation>La sélection n’a pas de nœuds · cliquer un mur, une ligne, un polygone ou l’arrivée pour le modifier</translation>
    </message>
    <message>
        <source>Nodes · click or rubber band: select nodes · Shift + Alt + drag: lasso · double click on a segment: insert a node · Escape: done</source>
        <translation>Nœuds · clic ou cadre&#xa0;: sélectionner des nœuds · Maj + Alt + glisser&#xa0;: lasso · double-clic sur un segment&#xa0;: insérer un nœud · Échap&#xa0;: fini</translation>
    </message>
    <message>
        <source>Click: edit the nodes of this object · Shift + click: add it to those in edit</source>
        <translation>Clic&#xa0;: modifier les nœuds de cet objet · Maj + clic&#xa0;: l’ajouter aux objets en cours</translation>
    </message>
    <message>
        <source>%1 nodes selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Shift+J: join · Shift+R: turn the part between them round as a chain of its own · Escape: select none</source>
        <translation>Nœuds sélectionnés&#xa0;: %1 · glisser&#xa0;: déplacer · flèches&#xa0;: décaler · Suppr&#xa0;: supprimer · Maj+B&#xa0;: briser · Maj+J&#xa0;: joindre · Maj+R&#xa0;: inverser la partie entre eux comme chaîne à part · Échap&#xa0;: ne rien sélectionner</translation>
    </message>
    <message>
        <source>Node · drag: move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band · Alt while dragging: leave other nodes at this place behind</source>
        <translation>Nœud · glisser&#xa0;: déplacer · Maj ou Ctrl + clic&#xa0;: ajouter ou retirer · Maj + glisser&#xa0;: cadre · Alt en glissant&#xa0;: laisser là les autres nœuds de ce lieu</translation>
    </message>
    <message>
        <source>Segment · drag: move both ends · click: select them · double click or Ctrl + Alt + click: insert a node here</source>
        <translation>Segment · glisser&#xa0;: déplacer les deux bouts · clic&#xa0;: les sélectionner · double-clic ou Ctrl + Alt + clic&#xa0;: insérer ici un nœud</translation>
    </message>
    <message>
        <source>Click: insert a node here</source>
        <translation>Clic&#xa0;: insérer ici un nœud</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Déplacement de %1 m, %2 m · Maj&#xa0;: selon un axe · Ctrl&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m together with other nodes at this place · Alt: leave them behind · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Déplacement de %1 m, %2 m avec les autres nœuds de ce lieu · Alt&#xa0;: les laisser là · Maj&#xa0;: selon un axe · Ctrl&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Two neighbouring nodes lie on one point, which leaves a side without length · move on, or Escape to cancel</source>
        <translation>Deux nœuds voisins sont au même point, ce qui laisse un côté sans longueur · éloignez-vous, ou Échap pour annuler</translation>
    </message>
    <message>
        <source>The polygon crosses itself like this and cannot be played · move on, or Escape to cancel</source>
        <translation>Ainsi, le polygone se croise et ne peut être joué · éloignez-vous, ou Échap pour annuler</translation>
    </message>
    <message>
        <source>Drag: scale the selected nodes · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · click a selected node: turn them instead</source>
        <translation>Glisser&#xa0;: redimensionner les nœuds sélectionnés · Maj&#xa0;: autour du milieu · Ctrl&#xa0;: en proportion · Alt&#xa0;: aimant non/oui · cliquer un nœud sélectionné&#xa0;: les tourner plutôt</translation>
    </message>
    <message>
        <source>Drag: turn the selected nodes · Ctrl: in steps of 15° · click a selected node: scale them instead</source>
        <translation>Glisser&#xa0;: tourner les nœuds sélectionnés · Ctrl&#xa0;: par pas de 15° · cliquer un nœud sélectionné&#xa0;: les redimensionner plutôt</translation>
    </message>
    <message>
        <source>Scaling to %1 m × %2 m · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · Escape: cancel</source>
        <translation>Redimensionner à %1 m × %2 m · Maj&#xa0;: autour du milieu · Ctrl&#xa0;: en proportion · Alt&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Turning by %1° · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Rotation de %1° · Ctrl&#xa0;: par pas de 15° · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Knife · drag a line across walls, lines and polygons to cut them · Shift: 15° · Ctrl: snap off/on</source>
        <translation>Couteau · glisser une ligne à travers murs, lignes et polygones pour les couper · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>Knife · drag a line across to cut what is selected (%1) · Escape: select nothing, so as to cut everything</source>
        <translation>Couteau · glisser une ligne à travers la sélection (%1) pour la couper · Échap&#xa0;: ne rien sélectionner, pour tout couper</translation>
    </message>
    <message>
        <source>Nothing to cut here yet · chains are cut where the line meets them, polygons where it goes right through</source>
        <translation>Rien à couper ici pour l’instant · les chaînes sont coupées où la ligne les rencontre, les polygones où elle les traverse</translation>
    </message>
    <message>
        <source>Ship · click: put it here · drag: turn its nose · Ctrl: snap off/on · choose the tool again for the payload</source>
        <translation>Vaisseau · clic&#xa0;: le poser ici · glisser&#xa0;: tourner son nez · Ctrl&#xa0;: aimant non/oui · reprendre l’outil pour la charge</translation>
    </message>
    <message>
        <source>Nose at %1° · Shift: 15° · release: done · Escape: cancel</source>
        <translation>Nez à %1° · Maj&#xa0;: 15° · relâcher&#xa0;: fini · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Payload · click: put it here · drag: move it into place · Ctrl: snap off/on · choose the tool again for the finish</source>
        <translation>Charge · clic&#xa0;: la poser ici · glisser&#xa0;: la mettre en place · Ctrl&#xa0;: aimant non/oui · reprendre l’outil pour l’arrivée</translation>
    </message>
    <message>
        <source>Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>Charge à %1 m, %2 m · Ctrl&#xa0;: aimant non/oui · relâcher&#xa0;: fini · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Finish line · drag it, or click one end and then click or type the other · Ctrl: snap off/on · choose the tool again for the ship</source>
        <translation>Ligne d’arrivée · la glisser, ou cliquer un bout puis cliquer ou saisir l’autre · Ctrl&#xa0;: aimant non/oui · reprendre l’outil pour le vaisseau</translation>
    </message>
    <message>
        <source>Finish line · click or release at the other end · Shift: 15° · Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel</source>
        <translation>Ligne d’arrivée · cliquer ou relâcher à l’autre bout · Maj&#xa0;: 15° · Ctrl&#xa0;: aimant non/oui · longueur %1 m, angle %2° · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>The finish needs two ends: move away from the first before you click</source>
        <translation>L’arrivée demande deux bouts&#xa0;: éloignez-vous du premier avant de cliquer</translation>
    </message>
    <message>
        <source>Click: select · drag: rubber band · Shift + Alt (or B) + drag: lasso · Shift or Ctrl + click: add or remove · Alt or B + click: next object underneath</source>
        <translation>Clic&#xa0;: sélectionner · glisser&#xa0;: cadre · Maj + Alt (ou B) + glisser&#xa0;: lasso · Maj ou Ctrl + clic&#xa0;: ajouter ou retirer · Alt ou B + clic&#xa0;: objet du dessous</translation>
    </message>
    <message>
        <source>Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band</source>
        <translation>Clic&#xa0;: sélectionner · glisser&#xa0;: sélectionner et déplacer · Maj ou Ctrl + clic&#xa0;: ajouter ou retirer · Maj + glisser&#xa0;: cadre</translation>
    </message>
    <message>
        <source>%1 selected · drag: move · click again: turn or scale · Alt or B + drag: move from anywhere · Shift or Ctrl + click: add or remove · Delete: remove · Escape: select nothing</source>
        <translation>Sélection&#xa0;: %1 · glisser&#xa0;: déplacer · recliquer&#xa0;: tourner ou redimensionner · Alt ou B + glisser&#xa0;: déplacer de n’importe où · Maj ou Ctrl + clic&#xa0;: ajouter ou retirer · Suppr&#xa0;: supprimer · Échap&#xa0;: ne rien sélectionner</translation>
    </message>
    <message>
        <source>Click: select the group · double click: enter it · Ctrl + click: select by itself · drag: select and move · Shift + click: add or remove</source>
        <translation>Clic&#xa0;: sélectionner le groupe · double-clic&#xa0;: y entrer · Ctrl + clic&#xa0;: sélectionner seul · glisser&#xa0;: sélectionner et déplacer · Maj + clic&#xa0;: ajouter ou retirer</translation>
    </message>
    <message>
        <source>%1 selected · double click: enter the group · drag: move · click again: turn or scale · Ctrl + click: select by itself · Delete: remove</source>
        <translation>Sélection&#xa0;: %1 · double-clic&#xa0;: entrer dans le groupe · glisser&#xa0;: déplacer · recliquer&#xa0;: tourner ou redimensionner · Ctrl + clic&#xa0;: sélectionner seul · Suppr&#xa0;: supprimer</translation>
    </message>
    <message>
        <source>Inside a group, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>Dans un groupe, sélection&#xa0;: %1 · les clics sélectionnent ses membres · Échap, ou double-clic dans le vide&#xa0;: en sortir</translation>
    </message>
    <message>
        <source>Inside “%2”, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>Dans «&#xa0;%2&#xa0;», sélection&#xa0;: %1 · les clics sélectionnent ses membres · Échap, ou double-clic dans le vide&#xa0;: en sortir</translation>
    </message>
    <message>
        <source>%1 selected · Ctrl: only what lies wholly inside · Escape: cancel</source>
        <translation>Sélection&#xa0;: %1 · Ctrl&#xa0;: seulement ce qui est tout entier dedans · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Node · drag: move it alone · Alt or B + drag: move the whole object · double click: edit all nodes</source>
        <translation>Nœud · glisser&#xa0;: le déplacer seul · Alt ou B + glisser&#xa0;: déplacer tout l’objet · double-clic&#xa0;: modifier tous les nœuds</translation>
    </message>
    <message>
        <source>Drag: scale · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on</source>
        <translation>Glisser&#xa0;: redimensionner · Maj&#xa0;: autour du milieu · Ctrl&#xa0;: garder les proportions · Alt ou B&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>%1 × %2 m (%3 %, %4 %) · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on · Escape: cancel</source>
        <translation>%1 × %2 m (%3 %, %4 %) · Maj&#xa0;: autour du milieu · Ctrl&#xa0;: garder les proportions · Alt ou B&#xa0;: aimant non/oui · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Drag: turn about the pivot · Shift: about the opposite corner · Ctrl: in steps of 15° · click the object: scale</source>
        <translation>Glisser&#xa0;: tourner autour du pivot · Maj&#xa0;: autour du coin opposé · Ctrl&#xa0;: par pas de 15° · cliquer l’objet&#xa0;: redimensionner</translation>
    </message>
    <message>
        <source>Turning by %1° · Shift: about the opposite corner · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>Rotation de %1° · Maj&#xa0;: autour du coin opposé · Ctrl&#xa0;: par pas de 15° · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Drag: move the pivot, about which the selection turns · Ctrl: snap off/on</source>
        <translation>Glisser&#xa0;: déplacer le pivot autour duquel la sélection tourne · Ctrl&#xa0;: aimant non/oui</translation>
    </message>
    <message>
        <source>%1 selected · Alt or B: only what lies wholly inside · Escape: cancel</source>
        <translation>Sélection&#xa0;: %1 · Alt ou B&#xa0;: seulement ce qui est tout entier dedans · Échap&#xa0;: annuler</translation>
    </message>
    <message>
        <source>Draw one-way walls</source>
        <translation>Dessiner des murs à sens unique</translation>
    </message>
    <message>
        <source>Draw two-sided walls</source>
        <translation>Dessiner des lignes à double sens</translation>
    </message>
    <message>
        <source>Draw polygon</source>
        <translation>Dessiner un polygone</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>Dessiner un cercle</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>Dessiner un rectangle</translation>
    </message>
    <message>
        <source>Draw moving body</source>
        <translation>Dessiner un corps mobile</translation>
    </message>
    <message>
        <source>Draw connector</source>
        <translation>Dessiner un connecteur</translation>
    </message>
    <message>
        <source>Set velocity</source>
        <translation>Fixer la vitesse</translation>
    </message>
    <message>
        <source>Extend chain</source>
        <translation>Prolonger la chaîne</translation>
    </message>
    <message>
        <source>Place ship</source>
        <translation>Placer le vaisseau</translation>
    </message>
    <message>
        <source>Place payload</source>
        <translation>Placer la charge</translation>
    </message>
    <message>
        <source>Place finish</source>
        <translation>Placer l’arrivée</translation>
    </message>
    <message>
        <source>Reopen level</source>
        <translation>Rouvrir le niveau</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>Déplacer l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Déplacer %n objet</numerusform>
            <numerusform>Déplacer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate object</source>
        <translation>Tourner l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n objects</source>
        <translation>
            <numerusform>Tourner %n objet</numerusform>
            <numerusform>Tourner %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale object</source>
        <translation>Redimensionner l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n objects</source>
        <translation>
            <numerusform>Redimensionner %n objet</numerusform>
            <numerusform>Redimensionner %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip object</source>
        <translation>Retourner l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Flip %n objects</source>
        <translation>
            <numerusform>Retourner %n objet</numerusform>
            <numerusform>Retourner %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Align object</source>
        <translation>Aligner l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Align %n objects</source>
        <translation>
            <numerusform>Aligner %n objet</numerusform>
            <numerusform>Aligner %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Distribute object</source>
        <translation>Répartir l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n objects</source>
        <translation>
            <numerusform>Répartir %n objet</numerusform>
            <numerusform>Répartir %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Reorder object</source>
        <translation>Réordonner l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Reorder %n objects</source>
        <translation>
            <numerusform>Réordonner %n objet</numerusform>
            <numerusform>Réordonner %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Group object</source>
        <translation>Grouper l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Group %n objects</source>
        <translation>
            <numerusform>Grouper %n objet</numerusform>
            <numerusform>Grouper %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>Dégrouper</translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n groups</source>
        <translation>
            <numerusform>Dégrouper %n groupe</numerusform>
            <numerusform>Dégrouper %n groupes</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another layer</source>
        <translation>Mettre l’objet dans un autre calque</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another layer</source>
        <translation>
            <numerusform>Mettre %n objet dans un autre calque</numerusform>
            <numerusform>Mettre %n objets dans un autre calque</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another group</source>
        <translation>Mettre l’objet dans un autre groupe</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another group</source>
        <translation>
            <numerusform>Mettre %n objet dans un autre groupe</numerusform>
            <numerusform>Mettre %n objets dans un autre groupe</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename object</source>
        <translation>Renommer l’objet</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Afficher l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Show %n objects</source>
        <translation>
            <numerusform>Afficher %n objet</numerusform>
            <numerusform>Afficher %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Déverrouiller l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n objects</source>
        <translation>
            <numerusform>Déverrouiller %n objet</numerusform>
            <numerusform>Déverrouiller %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Masquer l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n objects</source>
        <translation>
            <numerusform>Masquer %n objet</numerusform>
            <numerusform>Masquer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Isolate object</source>
        <translation>Isoler l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Isolate %n objects</source>
        <translation>
            <numerusform>Isoler %n objet</numerusform>
            <numerusform>Isoler %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Verrouiller l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n objects</source>
        <translation>
            <numerusform>Verrouiller %n objet</numerusform>
            <numerusform>Verrouiller %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Repeat transform</source>
        <translation>Répéter la transformation</translation>
    </message>
    <message numerus="yes">
        <source>Repeat transform of %n objects</source>
        <translation>
            <numerusform>Répéter la transformation de %n objet</numerusform>
            <numerusform>Répéter la transformation de %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Nouveau calque</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>Tout déverrouiller</translation>
    </message>
    <message>
        <source>Array of one copy</source>
        <translation>Réseau d’une copie</translation>
    </message>
    <message numerus="yes">
        <source>Array of %n copies</source>
        <translation>
            <numerusform>Réseau de %n copie</numerusform>
            <numerusform>Réseau de %n copies</numerusform>
        </translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>Unir les corps</translation>
    </message>
    <message numerus="yes">
        <source>Unite %n objects</source>
        <translation>
            <numerusform>Unir %n objet</numerusform>
            <numerusform>Unir %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Subtract bodies</source>
        <translation>Soustraire les corps</translation>
    </message>
    <message numerus="yes">
        <source>Subtract %n objects</source>
        <translation>
            <numerusform>Soustraire %n objet</numerusform>
            <numerusform>Soustraire %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Intersect bodies</source>
        <translation>Intersection des corps</translation>
    </message>
    <message numerus="yes">
        <source>Intersect %n objects</source>
        <translation>
            <numerusform>Intersection de %n objet</numerusform>
            <numerusform>Intersection de %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove points on straight sides</source>
        <translation>Retirer les points sur les côtés droits</translation>
    </message>
    <message>
        <source>Merge points</source>
        <translation>Fusionner les points</translation>
    </message>
    <message>
        <source>Turn outline round</source>
        <translation>Inverser le contour</translation>
    </message>
    <message>
        <source>Reverse wall</source>
        <translation>Inverser le mur</translation>
    </message>
    <message>
        <source>Close gap</source>
        <translation>Combler l’écart</translation>
    </message>
    <message>
        <source>Add the missing wall</source>
        <translation>Ajouter le mur manquant</translation>
    </message>
    <message>
        <source>Remove what is there twice</source>
        <translation>Retirer ce qui est en double</translation>
    </message>
    <message>
        <source>Limit depth</source>
        <translation>Limiter la profondeur</translation>
    </message>
    <message>
        <source>Choose plain background</source>
        <translation>Choisir un fond uni</translation>
    </message>
    <message>
        <source>Move out of group</source>
        <translation>Sortir du groupe</translation>
    </message>
    <message>
        <source>Give a new key</source>
        <translation>Nouvelle clé</translation>
    </message>
    <message>
        <source>Tag as wall</source>
        <translation>Étiqueter comme mur</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>L’afficher</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Le supprimer</translation>
    </message>
    <message>
        <source>Remove broken shapes</source>
        <translation>Supprimer les formes brisées</translation>
    </message>
    <message>
        <source>Untangle outline</source>
        <translation>Démêler le contour</translation>
    </message>
    <message>
        <source>Move to a free place</source>
        <translation>Mettre à une place libre</translation>
    </message>
    <message>
        <source>Fix all safe problems</source>
        <translation>Tout corriger sans risque</translation>
    </message>
    <message>
        <source>Hide problem</source>
        <translation>Masquer le problème</translation>
    </message>
    <message>
        <source>Show hidden problem</source>
        <translation>Afficher le problème masqué</translation>
    </message>
    <message>
        <source>Reverse object</source>
        <translation>Inverser l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Reverse %n objects</source>
        <translation>
            <numerusform>Inverser %n objet</numerusform>
            <numerusform>Inverser %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Take over object</source>
        <translation>Reprendre l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Take over %n objects</source>
        <translation>
            <numerusform>Reprendre %n objet</numerusform>
            <numerusform>Reprendre %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Supprimer l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Supprimer %n objet</numerusform>
            <numerusform>Supprimer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>Déplacer le nœud</translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>Déplacer %n nœud</numerusform>
            <numerusform>Déplacer %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate nodes</source>
        <translation>Tourner les nœuds</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n nodes</source>
        <translation>
            <numerusform>Tourner %n nœud</numerusform>
            <numerusform>Tourner %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale nodes</source>
        <translation>Redimensionner les nœuds</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n nodes</source>
        <translation>
            <numerusform>Redimensionner %n nœud</numerusform>
            <numerusform>Redimensionner %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>Insérer des nœuds</translation>
    </message>
    <message>
        <source>Delete node</source>
        <translation>Supprimer le nœud</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n nodes</source>
        <translation>
            <numerusform>Supprimer %n nœud</numerusform>
            <numerusform>Supprimer %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>Supprimer les segments</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>Joindre les nœuds</translation>
    </message>
    <message>
        <source>Break at node</source>
        <translation>Briser au nœud</translation>
    </message>
    <message numerus="yes">
        <source>Break at %n nodes</source>
        <translation>
            <numerusform>Briser à %n nœud</numerusform>
            <numerusform>Briser à %n nœuds</numerusform>
        </translation>
    </message>
    <message>
        <source>Reverse part</source>
        <translation>Inverser la partie</translation>
    </message>
    <message>
        <source>Straighten segments</source>
        <translation>Redresser les segments</translation>
    </message>
    <message>
        <source>Cut with the knife</source>
        <translation>Couper au couteau</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Dupliquer l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n objects</source>
        <translation>
            <numerusform>Dupliquer %n objet</numerusform>
            <numerusform>Dupliquer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut object</source>
        <translation>Couper l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n objects</source>
        <translation>
            <numerusform>Couper %n objet</numerusform>
            <numerusform>Couper %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Modifier l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Change %n objects</source>
        <translation>
            <numerusform>Modifier %n objet</numerusform>
            <numerusform>Modifier %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Change level</source>
        <translation>Modifier le niveau</translation>
    </message>
    <message>
        <source>Change who touches whom</source>
        <translation>Modifier qui touche qui</translation>
    </message>
    <message>
        <source>Change tag</source>
        <translation>Modifier l’étiquette</translation>
    </message>
    <message>
        <source>Paste object</source>
        <translation>Coller l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n objects</source>
        <translation>
            <numerusform>Coller %n objet</numerusform>
            <numerusform>Coller %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>Recharger du disque</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Récupérer le travail perdu</translation>
    </message>
    <message>
        <source>Open backup</source>
        <translation>Ouvrir la sauvegarde</translation>
    </message>
    <message>
        <source>Import object</source>
        <translation>Importer l’objet</translation>
    </message>
    <message numerus="yes">
        <source>Import %n objects</source>
        <translation>
            <numerusform>Importer %n objet</numerusform>
            <numerusform>Importer %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>Ajouter un guide</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>Modifier le guide</translation>
    </message>
    <message>
        <source>Delete guide</source>
        <translation>Supprimer le guide</translation>
    </message>
    <message>
        <source>Delete all guides</source>
        <translation>Supprimer tous les guides</translation>
    </message>
    <message>
        <source>The file “%1” cannot be read: %2.</source>
        <translation>Impossible de lire le fichier «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: %2. What was there before is still there.</source>
        <translation>Impossible d’écrire le fichier «&#xa0;%1&#xa0;»&#xa0;: %2. L’ancien contenu est toujours là.</translation>
    </message>
    <message>
        <source>The disk is full, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>Le disque est plein&#xa0;: impossible d’écrire le fichier «&#xa0;%1&#xa0;». L’ancien contenu est toujours là.</translation>
    </message>
    <message>
        <source>You have used up your share of the disk, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>Votre quota de disque est épuisé&#xa0;: impossible d’écrire le fichier «&#xa0;%1&#xa0;». L’ancien contenu est toujours là.</translation>
    </message>
    <message>
        <source>The disk with the file “%1” can only be read, so it cannot be written.</source>
        <translation>Le disque du fichier «&#xa0;%1&#xa0;» est en lecture seule&#xa0;: impossible de l’écrire.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: there is no folder “%2” any more.</source>
        <translation>Impossible d’écrire le fichier «&#xa0;%1&#xa0;»&#xa0;: le dossier «&#xa0;%2&#xa0;» n’existe plus.</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: you may not make files in the folder “%2”.</source>
        <translation>Impossible d’écrire le fichier «&#xa0;%1&#xa0;»&#xa0;: vous ne pouvez pas créer de fichiers dans le dossier «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>The file “%1” is protected: you may read it, but not write it.</source>
        <translation>Le fichier «&#xa0;%1&#xa0;» est protégé&#xa0;: vous pouvez le lire, mais pas l’écrire.</translation>
    </message>
    <message>
        <source>The file “%1” has been changed by somebody else meanwhile, so it was not overwritten.</source>
        <translation>Le fichier «&#xa0;%1&#xa0;» a été modifié entre-temps par un autre&#xa0;: il n’a pas été écrasé.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. What was there before is lost; save it elsewhere.</source>
        <translation>Le fichier «&#xa0;%1&#xa0;» n’a été écrit qu’en partie&#xa0;: %2. L’ancien contenu est perdu&#xa0;; enregistrez ailleurs.</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. All that it was to hold is in the file “%3”.</source>
        <translation>Le fichier «&#xa0;%1&#xa0;» n’a été écrit qu’en partie&#xa0;: %2. Tout ce qu’il devait contenir est dans le fichier «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>“%1” is not a finite number, and a file cannot hold it.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre fini, et un fichier ne peut le contenir.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must lie between %3 and %4.</source>
        <translation>«&#xa0;%1&#xa0;» vaut %2&#xa0;; il doit être entre %3 et %4.</translation>
    </message>
    <message>
        <source>The mass is too small or too large to be computed with, so the body would be missing from the game.</source>
        <translation>La masse est trop petite ou trop grande pour le calcul&#xa0;: le corps manquerait dans le jeu.</translation>
    </message>
    <message>
        <source>The body is so small and light, or so large and heavy, that its mass or inertia cannot be computed with. It would be missing from the game.</source>
        <translation>Le corps est si petit et léger, ou si grand et lourd, que sa masse ou son inertie échappe au calcul. Il manquerait dans le jeu.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be more than zero.</source>
        <translation>«&#xa0;%1&#xa0;» vaut %2&#xa0;; il doit être supérieur à zéro.</translation>
    </message>
    <message>
        <source>Select at least two bodies made of polygons, not locked.</source>
        <translation>Sélectionnez au moins deux corps faits de polygones, non verrouillés.</translation>
    </message>
    <message>
        <source>“%1” is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas fait que de polygones. Seuls des polygones peuvent être unis, soustraits et croisés.</translation>
    </message>
    <message>
        <source>These bodies lie too far from the origin to be combined: at most 500 km.</source>
        <translation>Ces corps sont trop loin de l’origine pour être combinés&#xa0;: 500 km au plus.</translation>
    </message>
    <message>
        <source>Nothing would be left of these bodies, so they stay as they are.</source>
        <translation>Il ne resterait rien de ces corps, ils restent donc tels quels.</translation>
    </message>
    <message>
        <source>The result would cross itself, so the bodies stay as they are. Move one of them a little and try again.</source>
        <translation>Le résultat se croiserait, les corps restent donc tels quels. Déplacez l’un d’eux un peu et réessayez.</translation>
    </message>
    <message>
        <source>The file starts with a byte order mark, which saving will leave out.</source>
        <translation>Le fichier commence par une marque d’ordre d’octets, que l’enregistrement omettra.</translation>
    </message>
    <message>
        <source>“%1” is not expected here: something is wrong at this place or just before it.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas attendu ici&#xa0;: une erreur se trouve à cet endroit ou juste avant.</translation>
    </message>
    <message>
        <source>A text is not closed with a quotation mark before its line ends.</source>
        <translation>Un texte n’est pas fermé par un guillemet avant la fin de sa ligne.</translation>
    </message>
    <message>
        <source>The control character %1 cannot stand here as it is.</source>
        <translation>Le caractère de contrôle %1 ne peut figurer ici tel quel.</translation>
    </message>
    <message>
        <source>“%1” is not a number that a file can hold; write a finite one.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre admis dans un fichier&#xa0;; écrivez-en un fini.</translation>
    </message>
    <message>
        <source>There is a comma before “%1” that nothing follows; leave it out.</source>
        <translation>Il y a avant «&#xa0;%1&#xa0;» une virgule que rien ne suit&#xa0;; ôtez-la.</translation>
    </message>
    <message>
        <source>The number %1 is larger than any that can be computed with.</source>
        <translation>Le nombre %1 dépasse tout ce qui peut être calculé.</translation>
    </message>
    <message>
        <source>Lists and objects lie more than %1 deep in one another.</source>
        <translation>Listes et objets sont imbriqués sur plus de %1 niveaux.</translation>
    </message>
    <message>
        <source>The file holds more than %1 values.</source>
        <translation>Le fichier contient plus de %1 valeurs.</translation>
    </message>
    <message>
        <source>The level is so large that it could not be saved again, so it is not opened.</source>
        <translation>Le niveau est si grand qu’il ne pourrait plus être enregistré&#xa0;: il n’est pas ouvert.</translation>
    </message>
    <message>
        <source>The file holds more than %1 vertices.</source>
        <translation>Le fichier contient plus de %1 sommets.</translation>
    </message>
    <message>
        <source>The field “%1” is given twice.</source>
        <translation>Le champ «&#xa0;%1&#xa0;» est donné deux fois.</translation>
    </message>
    <message>
        <source>This is not a level: it should be an object in braces, but is %1.</source>
        <translation>Ce n’est pas un niveau&#xa0;: ce devrait être un objet entre accolades, mais c’est %1.</translation>
    </message>
    <message>
        <source>This is not a level: the field “schema” is missing (it should be %1).</source>
        <translation>Ce n’est pas un niveau&#xa0;: le champ «&#xa0;schema&#xa0;» manque (il devrait valoir %1).</translation>
    </message>
    <message>
        <source>The level was made with a newer version (schema %1; this one reads up to %2). Please update the program.</source>
        <translation>Le niveau vient d’une version plus récente (schéma %1&#xa0;; celle-ci lit jusqu’à %2). Mettez à jour le programme.</translation>
    </message>
    <message>
        <source>The schema %1 is not known; this version reads %2.</source>
        <translation>Le schéma %1 est inconnu&#xa0;; cette version lit %2.</translation>
    </message>
    <message>
        <source>The field “%1” is missing.</source>
        <translation>Le champ «&#xa0;%1&#xa0;» manque.</translation>
    </message>
    <message>
        <source>The field “%1” is not known here. It is kept, but does nothing.</source>
        <translation>Le champ «&#xa0;%1&#xa0;» est inconnu ici. Il est gardé, mais sans effet.</translation>
    </message>
    <message>
        <source>“%1” must be a number, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre entier, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be a number, or null for a wall without a back, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre, ou null pour un mur sans dos, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be true or false, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être true ou false, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be a text, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être un texte, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be two numbers [x, y], not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être deux nombres [x, y], pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be a list in brackets, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être une liste entre crochets, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must hold objects in braces, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit contenir des objets entre accolades, pas %2.</translation>
    </message>
    <message>
        <source>“%1” must be “all”, a list of tags or {&quot;except&quot;: a list of tags}, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être «&#xa0;all&#xa0;», une liste d’étiquettes ou {&quot;except&quot;: une liste d’étiquettes}, pas %2.</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be one of: %3.</source>
        <translation>«&#xa0;%1&#xa0;» vaut %2&#xa0;; il doit être l’un de&#xa0;: %3.</translation>
    </message>
    <message>
        <source>There is no tag named “%1” in this level.</source>
        <translation>Aucune étiquette nommée «&#xa0;%1&#xa0;» dans ce niveau.</translation>
    </message>
    <message>
        <source>“%1” must be eight hexadecimal digits that are not all zero, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être huit chiffres hexadécimaux, pas tous nuls, et non %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by the object in line %2.</source>
        <translation>La clé %1 est prise par l’objet de la ligne %2.</translation>
    </message>
    <message>
        <source>The key %1 is taken by another object.</source>
        <translation>La clé %1 est prise par un autre objet.</translation>
    </message>
    <message>
        <source>There are two tags named “%1”.</source>
        <translation>Deux étiquettes se nomment «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>There are two tags with the index %1.</source>
        <translation>Deux étiquettes ont l’indice %1.</translation>
    </message>
    <message>
        <source>“%1” must be a whole number from 0 to 31, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être un nombre entier de 0 à 31, pas %2.</translation>
    </message>
    <message>
        <source>A tag cannot be named “%1”: that is how a tag without a name is written.</source>
        <translation>Une étiquette ne peut se nommer «&#xa0;%1&#xa0;»&#xa0;: c’est ainsi que s’écrit une étiquette sans nom.</translation>
    </message>
    <message>
        <source>“%1” must be a color such as &quot;#4cc9f0&quot;, not %2.</source>
        <translation>«&#xa0;%1&#xa0;» doit être une couleur comme &quot;#4cc9f0&quot;, pas %2.</translation>
    </message>
    <message>
        <source>There are %1 more problems, which are not listed.</source>
        <translation>Il y a %1 autres problèmes, qui ne sont pas listés.</translation>
    </message>
    <message>
        <source>The level has no ship. Place one, or remove payload and finish to make it a sandbox.</source>
        <translation>Le niveau n’a pas de vaisseau. Placez-en un, ou supprimez charge et arrivée pour en faire un bac à sable.</translation>
    </message>
    <message>
        <source>The level has no payload. Place one, or remove ship and finish to make it a sandbox.</source>
        <translation>Le niveau n’a pas de charge. Placez-en une, ou supprimez vaisseau et arrivée pour en faire un bac à sable.</translation>
    </message>
    <message>
        <source>The level has no finish. Place one, or remove ship and payload to make it a sandbox.</source>
        <translation>Le niveau n’a pas d’arrivée. Placez-en une, ou supprimez vaisseau et charge pour en faire un bac à sable.</translation>
    </message>
    <message>
        <source>There is more than one ship; only the first flies.</source>
        <translation>Il y a plus d’un vaisseau&#xa0;; seul le premier vole.</translation>
    </message>
    <message>
        <source>There is more than one payload; only the first counts.</source>
        <translation>Il y a plus d’une charge&#xa0;; seule la première compte.</translation>
    </message>
    <message>
        <source>There is more than one finish; only the first counts.</source>
        <translation>Il y a plus d’une arrivée&#xa0;; seule la première compte.</translation>
    </message>
    <message>
        <source>The ship starts in touch with the object “%1” and would crash at once.</source>
        <translation>Le vaisseau part en touchant l’objet «&#xa0;%1&#xa0;» et s’écraserait aussitôt.</translation>
    </message>
    <message>
        <source>The payload starts in touch with the object “%1”.</source>
        <translation>La charge part en touchant l’objet «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>The ship starts in touch with %2 at %3; %4 m and would crash at once.</source>
        <translation>Le vaisseau part en touchant %2 à %3&#xa0;; %4 m et s’écraserait aussitôt.</translation>
    </message>
    <message>
        <source>The payload starts in touch with %2 at %3; %4 m.</source>
        <translation>La charge part en touchant %2 à %3&#xa0;; %4 m.</translation>
    </message>
    <message>
        <source>the one-way wall</source>
        <translation>le mur à sens unique</translation>
    </message>
    <message>
        <source>the two-way line</source>
        <translation>la ligne à double sens</translation>
    </message>
    <message>
        <source>the polygon</source>
        <translation>le polygone</translation>
    </message>
    <message>
        <source>the circle</source>
        <translation>le cercle</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>le corps</translation>
    </message>
    <message>
        <source>The body has no shape.</source>
        <translation>Le corps n’a pas de forme.</translation>
    </message>
    <message>
        <source>A chain of walls needs at least two vertices; this one has %1.</source>
        <translation>Une chaîne de murs demande au moins deux sommets&#xa0;; celle-ci en a %1.</translation>
    </message>
    <message>
        <source>All vertices of this chain of walls lie at the same point.</source>
        <translation>Tous les sommets de cette chaîne de murs sont au même point.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 lie at the same point: the wall between them has no length.</source>
        <translation>Les sommets %1 et %2 sont au même point&#xa0;: le mur entre eux n’a pas de longueur.</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 of the polygon lie at the same point.</source>
        <translation>Les sommets %1 et %2 du polygone sont au même point.</translation>
    </message>
    <message>
        <source>A polygon of %1 vertices is too large; %2 are allowed.</source>
        <translation>Un polygone de %1 sommets est trop grand&#xa0;; %2 sont permis.</translation>
    </message>
    <message>
        <source>A polygon needs at least three different vertices; this one has %1.</source>
        <translation>Un polygone demande au moins trois sommets distincts&#xa0;; celui-ci en a %1.</translation>
    </message>
    <message>
        <source>The polygon crosses itself: the sides from vertex %1 and from vertex %2 meet.</source>
        <translation>Le polygone se croise&#xa0;: les côtés partant des sommets %1 et %2 se rencontrent.</translation>
    </message>
    <message>
        <source>The polygon crosses itself.</source>
        <translation>Le polygone se croise.</translation>
    </message>
    <message>
        <source>All vertices of the polygon lie on one line: it encloses nothing.</source>
        <translation>Tous les sommets du polygone sont alignés&#xa0;: il n’entoure rien.</translation>
    </message>
    <message>
        <source>The vertices of the polygon run clockwise; they are taken the other way round.</source>
        <translation>Les sommets du polygone vont dans le sens horaire&#xa0;; ils sont pris dans l’autre sens.</translation>
    </message>
    <message>
        <source>It belongs to the group %1, which does not exist; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Il appartient au groupe %1, qui n’existe pas&#xa0;; il est affiché à la racine. Mettez-le dans un autre groupe, ou à la racine.</translation>
    </message>
    <message>
        <source>It belongs to the object %1, which is not a group; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>Il appartient à l’objet %1, qui n’est pas un groupe&#xa0;; il est affiché à la racine. Mettez-le dans un autre groupe, ou à la racine.</translation>
    </message>
    <message>
        <source>It is in the group %1, which is in it, directly or not; it is shown at the top. Put one of them to the top.</source>
        <translation>Il est dans le groupe %1, lui-même dans celui-ci, directement ou non&#xa0;; il est affiché à la racine. Mettez l’un d’eux à la racine.</translation>
    </message>
    <message>
        <source>A layer is in another group. Layers are at the top: put it there, or make it an ordinary group.</source>
        <translation>Un calque est dans un autre groupe. Les calques sont à la racine&#xa0;: mettez-le là, ou faites-en un groupe ordinaire.</translation>
    </message>
    <message>
        <source>It is hidden in the editor, but takes part in the game.</source>
        <translation>Il est masqué dans l’éditeur, mais participe au jeu.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which does not exist.</source>
        <translation>Le bout «&#xa0;%1&#xa0;» du connecteur est l’objet %2, qui n’existe pas.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which is not a body.</source>
        <translation>Le bout «&#xa0;%1&#xa0;» du connecteur est l’objet %2, qui n’est pas un corps.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same object.</source>
        <translation>Les deux bouts du connecteur sont sur le même objet.</translation>
    </message>
    <message>
        <source>A stiffness of %1 N/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Une raideur de %1 N/m est trop forte pour les sous-pas&#xa0;: le ressort peut trembler. Environ %2 sous-pas conviendraient.</translation>
    </message>
    <message>
        <source>A damping of %1 N s/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>Un amortissement de %1 N s/m est trop fort pour les sous-pas&#xa0;: le ressort peut trembler. Environ %2 sous-pas conviendraient.</translation>
    </message>
    <message>
        <source>The tags of this body are such that nothing can touch it.</source>
        <translation>Les étiquettes de ce corps sont telles que rien ne peut le toucher.</translation>
    </message>
    <message>
        <source>Points that lie on straight sides and do nothing: %1.</source>
        <translation>Points inutiles sur des côtés droits&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This wall is solid on the other side than the walls it goes on from: the ship can fly out through it. Reverse it.</source>
        <translation>Ce mur est solide de l’autre côté que les murs qu’il prolonge&#xa0;: le vaisseau peut s’échapper à travers. Inversez-le.</translation>
    </message>
    <message>
        <source>This wall and the one it goes on from are solid on different sides. Reverse one of them.</source>
        <translation>Ce mur et celui qu’il prolonge sont solides de côtés différents. Inversez l’un d’eux.</translation>
    </message>
    <message>
        <source>The two ends of this chain of walls are %1 mm apart, so it is not closed.</source>
        <translation>Les deux bouts de cette chaîne de murs sont à %1 mm l’un de l’autre&#xa0;: elle n’est pas fermée.</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to “%1”.</source>
        <translation>Il y a un écart de %5 mm avec «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to %2 at %3; %4 m.</source>
        <translation>Il y a un écart de %5 mm avec %2 à %3&#xa0;; %4 m.</translation>
    </message>
    <message>
        <source>This wall lies exactly on “%1”, which does the same.</source>
        <translation>Ce mur coïncide avec «&#xa0;%1&#xa0;», qui fait la même chose.</translation>
    </message>
    <message>
        <source>This wall lies exactly on %2 at %3; %4 m, which does the same.</source>
        <translation>Ce mur coïncide avec %2 à %3&#xa0;; %4 m, qui fait la même chose.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of “%1”: %5.</source>
        <translation>Murs qui coïncident avec ceux de «&#xa0;%1&#xa0;»&#xa0;: %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of %2 at %3; %4 m: %5.</source>
        <translation>Murs qui coïncident avec %2 à %3&#xa0;; %4 m&#xa0;: %5.</translation>
    </message>
    <message>
        <source>Walls that lie exactly on others of the same chain: %1.</source>
        <translation>Murs qui coïncident avec d’autres de la même chaîne&#xa0;: %1.</translation>
    </message>
    <message>
        <source>It lies exactly on “%1”, which is the same.</source>
        <translation>Il coïncide avec «&#xa0;%1&#xa0;», qui est identique.</translation>
    </message>
    <message>
        <source>It lies exactly on %2 at %3; %4 m, which is the same.</source>
        <translation>Il coïncide avec %2 à %3&#xa0;; %4 m, qui est identique.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but what is fastest here may move %2 m between two looks at what it touches, and may get through. Make it deeper, or raise the iterations.</source>
        <translation>Le mur a %1 m de profondeur, mais le plus rapide ici peut avancer de %2 m entre deux contrôles de contact, et passer à travers. Approfondissez-le, ou augmentez les itérations.</translation>
    </message>
    <message>
        <source>The wall has no back, so what is solid behind it reaches into the free space %1 m behind. Give it a depth of no more than that.</source>
        <translation>Le mur n’a pas de dos&#xa0;: sa partie solide s’étend dans l’espace libre à %1 m derrière. Ne lui donnez pas plus que cette profondeur.</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but %2 m behind it there is free space, into which it reaches. Give it a depth of no more than that.</source>
        <translation>Le mur a %1 m de profondeur, mais il y a de l’espace libre à %2 m derrière, où il s’étend. Ne lui donnez pas plus que cette profondeur.</translation>
    </message>
    <message>
        <source>The wall has no back, so all the free space behind it counts as solid. Give it a depth.</source>
        <translation>Le mur n’a pas de dos&#xa0;: tout l’espace libre derrière compte comme solide. Donnez-lui une profondeur.</translation>
    </message>
    <message>
        <source>The ship starts outside of the cave that the payload is in.</source>
        <translation>Le vaisseau part hors de la grotte où est la charge.</translation>
    </message>
    <message>
        <source>The payload is outside of the cave that the ship starts in.</source>
        <translation>La charge est hors de la grotte d’où part le vaisseau.</translation>
    </message>
    <message>
        <source>The finish is outside of the cave that the ship starts in.</source>
        <translation>L’arrivée est hors de la grotte d’où part le vaisseau.</translation>
    </message>
    <message>
        <source>Both ends of the finish lie at the same point, so nothing can cross it.</source>
        <translation>Les deux bouts de l’arrivée sont au même point&#xa0;: rien ne peut la franchir.</translation>
    </message>
    <message>
        <source>The payload starts on the finish.</source>
        <translation>La charge part sur l’arrivée.</translation>
    </message>
    <message>
        <source>Gravity is too strong: the ship weighs %1 N, and its thrust is %2 N.</source>
        <translation>La gravité est trop forte&#xa0;: le vaisseau pèse %1 N, et sa poussée est de %2 N.</translation>
    </message>
    <message>
        <source>Ship and payload together weigh %1 N; the ship&apos;s thrust of %2 N cannot lift them.</source>
        <translation>Vaisseau et charge pèsent ensemble %1 N&#xa0;; la poussée du vaisseau, %2 N, ne peut les soulever.</translation>
    </message>
    <message>
        <source>There is no background named “%1”; it is shown as a plain one.</source>
        <translation>Aucun fond nommé «&#xa0;%1&#xa0;»&#xa0;; il est affiché uni.</translation>
    </message>
    <message>
        <source>The ship flies through this wall: it does not have the tag “%1”.</source>
        <translation>Le vaisseau traverse ce mur&#xa0;: il n’a pas l’étiquette «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through “%1”.</source>
        <translation>Il n’est fait que de murs, et des murs ne se rencontrent jamais&#xa0;: il tombe à travers «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through %2 at %3; %4 m.</source>
        <translation>Il n’est fait que de murs, et des murs ne se rencontrent jamais&#xa0;: il tombe à travers %2 à %3&#xa0;; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out through this wall: it is solid on the wrong side. Reverse it.</source>
        <translation>Le vaisseau peut sortir par ce mur : il est plein du mauvais côté. Inversez-le.</translation>
    </message>
    <message>
        <source>The ship can get out through this chain: all its %1 walls are solid on the wrong side. Reverse it.</source>
        <translation>Le vaisseau peut sortir par cette chaîne : ses %1 murs sont tous pleins du mauvais côté. Inversez-la.</translation>
    </message>
    <message>
        <source>The ship can get out through edge %1 of this chain: it is solid on the wrong side.</source>
        <translation>Le vaisseau peut sortir par l’arête %1 de cette chaîne : elle est pleine du mauvais côté.</translation>
    </message>
    <message>
        <source>The ship can get out: %1 walls, of which this is one, are solid on the wrong side.</source>
        <translation>Le vaisseau peut sortir : %1 murs, dont celui-ci, sont pleins du mauvais côté.</translation>
    </message>
    <message>
        <source>The ship can get out: this chain is not closed, its ends are %1 m apart.</source>
        <translation>Le vaisseau peut sortir : cette chaîne n’est pas fermée, ses extrémités sont à %1 m l’une de l’autre.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %1 m is missing between two ends of this object.</source>
        <translation>Le vaisseau peut sortir : il manque un mur de %1 m entre deux extrémités de cet objet.</translation>
    </message>
    <message>
        <source>The ship can get out: there is an opening of %1 m in this object.</source>
        <translation>Le vaisseau peut sortir : il y a une ouverture de %1 m dans cet objet.</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of “%1”.</source>
        <translation>Le vaisseau peut sortir : il manque un mur de %5 m entre l’extrémité de celui-ci et celle de « %1 ».</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of %2 at %3; %4 m.</source>
        <translation>Le vaisseau peut sortir : il manque un mur de %5 m entre l’extrémité de celui-ci et celle de %2 en %3 ; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before “%1”.</source>
        <translation>Le vaisseau peut sortir : ce mur s’arrête à %5 m de « %1 ».</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before %2 at %3; %4 m.</source>
        <translation>Le vaisseau peut sortir : ce mur s’arrête à %5 m de %2 en %3 ; %4 m.</translation>
    </message>
    <message>
        <source>The ship can get out between this and “%1”: they are %5 m apart.</source>
        <translation>Le vaisseau peut sortir entre cet objet et « %1 » : ils sont à %5 m l’un de l’autre.</translation>
    </message>
    <message>
        <source>The ship can get out between this and %2 at %3; %4 m: they are %5 m apart.</source>
        <translation>Le vaisseau peut sortir entre cet objet et %2 en %3 ; %4 m : ils sont à %5 m l’un de l’autre.</translation>
    </message>
    <message>
        <source>“%1” is not a mass that a body can have.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas une masse possible pour un corps.</translation>
    </message>
    <message>
        <source>The body has a shape that cannot be simulated.</source>
        <translation>Le corps a une forme qui ne peut être simulée.</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is not in the world.</source>
        <translation>Le bout «&#xa0;%1&#xa0;» du connecteur n’est pas dans le monde.</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same body.</source>
        <translation>Les deux bouts du connecteur sont sur le même corps.</translation>
    </message>
    <message>
        <source>These tags came along, as the level did not have them: %1.</source>
        <translation>Ces étiquettes ont suivi, car le niveau ne les avait pas&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The tag “%1” is called “%2” in this level.</source>
        <translation>L’étiquette «&#xa0;%1&#xa0;» s’appelle «&#xa0;%2&#xa0;» dans ce niveau.</translation>
    </message>
    <message>
        <source>All 32 tags of this level are in use, so these were left off: %1.</source>
        <translation>Les 32 étiquettes de ce niveau sont prises&#xa0;: celles-ci ont été ôtées&#xa0;: %1.</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>Il manque un nombre.</translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation>Il manque quelque chose à la fin.</translation>
    </message>
    <message>
        <source>“%1” cannot stand where it is.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas à sa place.</translation>
    </message>
    <message>
        <source>“%1” is neither a unit nor a function; try 2*pi/3, sqrt(2), 20 cm or +=0.5.</source>
        <translation>«&#xa0;%1&#xa0;» n’est ni une unité ni une fonction&#xa0;; essayez 2*pi/3, sqrt(2), 20 cm ou +=0.5.</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>Une parenthèse n’est pas fermée.</translation>
    </message>
    <message>
        <source>“%1” has another number of values; they are parted by semicolons.</source>
        <translation>«&#xa0;%1&#xa0;» a un autre nombre de valeurs&#xa0;; elles sont séparées par des points-virgules.</translation>
    </message>
    <message>
        <source>This is too long or too deeply nested.</source>
        <translation>C’est trop long ou trop imbriqué.</translation>
    </message>
    <message>
        <source>Nothing can be divided by zero.</source>
        <translation>Rien ne peut être divisé par zéro.</translation>
    </message>
    <message>
        <source>The result is too large, or is no number.</source>
        <translation>Le résultat est trop grand, ou n’est pas un nombre.</translation>
    </message>
    <message>
        <source>These units do not go together.</source>
        <translation>Ces unités ne vont pas ensemble.</translation>
    </message>
    <message>
        <source>The result must be a plain number or one in %1.</source>
        <translation>Le résultat doit être un simple nombre ou un nombre en %1.</translation>
    </message>
    <message>
        <source>This is a plain number without a unit.</source>
        <translation>C’est un simple nombre sans unité.</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>sommet</translation>
    </message>
    <message>
        <source>vertex of %1</source>
        <translation>sommet de %1</translation>
    </message>
    <message>
        <source>center</source>
        <translation>centre</translation>
    </message>
    <message>
        <source>center of %1</source>
        <translation>centre de %1</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>ancrage</translation>
    </message>
    <message>
        <source>anchor on %1</source>
        <translation>ancrage sur %1</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>intersection</translation>
    </message>
    <message>
        <source>intersection with %1</source>
        <translation>intersection avec %1</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>midpoint of %1</source>
        <translation>milieu de %1</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>perpendiculaire</translation>
    </message>
    <message>
        <source>perpendicular to %1</source>
        <translation>perpendiculaire à %1</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>arête</translation>
    </message>
    <message>
        <source>edge of %1</source>
        <translation>arête de %1</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>guide</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>guide %1</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>aligné</translation>
    </message>
    <message>
        <source>in line with %1</source>
        <translation>aligné sur %1</translation>
    </message>
    <message>
        <source>multiple of 15°</source>
        <translation>multiple de 15°</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>grille</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 et %2</translation>
    </message>
    <message>
        <source>once</source>
        <translation>une fois</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n fois</numerusform>
            <numerusform>%n fois</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in line %2</source>
        <translation>%1, à la ligne %2</translation>
    </message>
    <message>
        <source>%1, in lines %2</source>
        <translation>%1, aux lignes %2</translation>
    </message>
    <message>
        <source>What drawings within the drawing hide beyond their borders is there as well (%4).</source>
        <translation>Ce que des dessins dans le dessin cachent au-delà de leurs bords est là aussi (%4).</translation>
    </message>
    <message>
        <source>The width of wide strokes was not taken over: they are walls without thickness (%4). “Stroke to Path” of Inkscape makes areas of them.</source>
        <translation>La largeur des contours larges n’a pas été reprise : ce sont des murs sans épaisseur (%4). « Contour en chemin » d’Inkscape en fait des surfaces.</translation>
    </message>
    <message>
        <source>They touch: “%1” and “%2” are in contact.</source>
        <translation>Ils se touchent&#xa0;: «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» sont en contact.</translation>
    </message>
    <message>
        <source>Both are the same body, which does not collide with itself.</source>
        <translation>Les deux sont le même corps, qui ne se heurte pas lui-même.</translation>
    </message>
    <message>
        <source>“%1” is switched off, so it touches nothing.</source>
        <translation>«&#xa0;%1&#xa0;» est désactivé et ne touche donc rien.</translation>
    </message>
    <message>
        <source>Neither is moved by forces: “%1” and “%2” pass through each other unless one of them is dynamic.</source>
        <translation>Aucun des deux n’est mû par des forces&#xa0;: «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se traversent, à moins que l’un d’eux ne soit dynamique.</translation>
    </message>
    <message>
        <source>“%2” has no tags, and what has none is touched by nothing.</source>
        <translation>«&#xa0;%2&#xa0;» n’a pas d’étiquette, et rien ne touche ce qui n’en a pas.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3.</source>
        <translation>«&#xa0;%1&#xa0;» ne touche pas ce qu’est «&#xa0;%2&#xa0;»&#xa0;: %3.</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3. Nor does “%2” touch what “%1” is.</source>
        <translation>«&#xa0;%1&#xa0;» ne touche pas ce qu’est «&#xa0;%2&#xa0;»&#xa0;: %3. «&#xa0;%2&#xa0;» ne touche pas non plus ce qu’est «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>“%3” connects “%1” and “%2”, and bodies that it connects do not collide.</source>
        <translation>«&#xa0;%3&#xa0;» relie «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;», et les corps qu’il relie ne se heurtent pas.</translation>
    </message>
    <message>
        <source>The tow rope connects “%1” and “%2”, which therefore do not collide.</source>
        <translation>La corde de remorquage relie «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;», qui ne se heurtent donc pas.</translation>
    </message>
    <message>
        <source>“%1” is intangible: it would be felt, but stops nothing.</source>
        <translation>«&#xa0;%1&#xa0;» est intangible&#xa0;: on le sentirait, mais il n’arrête rien.</translation>
    </message>
    <message>
        <source>“%1” is intangible: “%2” touches it and is felt, but nothing stops it.</source>
        <translation>«&#xa0;%1&#xa0;» est intangible&#xa0;: «&#xa0;%2&#xa0;» le touche et est senti, mais rien ne l’arrête.</translation>
    </message>
    <message>
        <source>Both are nothing but walls, and walls pass through each other.</source>
        <translation>Les deux ne sont que des murs, et les murs se traversent.</translation>
    </message>
    <message>
        <source>“%1” and “%2” may collide, but are %3 m apart.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» peuvent se heurter, mais sont à %3 m l’un de l’autre.</translation>
    </message>
    <message>
        <source>“%1” and “%2” overlap, and collide as soon as the simulation goes on.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se chevauchent et se heurteront dès que la simulation continuera.</translation>
    </message>
    <message>
        <source>Let “%1” touch “%2”</source>
        <translation>Laisser «&#xa0;%1&#xa0;» toucher «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Give “%1” the tag “%2”</source>
        <translation>Donner à «&#xa0;%1&#xa0;» l’étiquette «&#xa0;%2&#xa0;»</translation>
    </message>
    <message>
        <source>Make “%1” tangible</source>
        <translation>Rendre «&#xa0;%1&#xa0;» tangible</translation>
    </message>
    <message>
        <source>Let the bodies of “%1” collide</source>
        <translation>Laisser les corps de «&#xa0;%1&#xa0;» se heurter</translation>
    </message>
    <message>
        <source>Back to before the run</source>
        <translation>Revenir à l’état d’avant l’exécution</translation>
    </message>
    <message>
        <source>Keep change of the level</source>
        <translation>Garder la modification du niveau</translation>
    </message>
    <message>
        <source>Keep new object</source>
        <translation>Garder le nouvel objet</translation>
    </message>
    <message>
        <source>Keep deletion</source>
        <translation>Garder la suppression</translation>
    </message>
    <message>
        <source>Keep move</source>
        <translation>Garder le déplacement</translation>
    </message>
    <message>
        <source>Keep tags</source>
        <translation>Garder les étiquettes</translation>
    </message>
    <message>
        <source>Keep order</source>
        <translation>Garder l’ordre</translation>
    </message>
    <message>
        <source>Keep change</source>
        <translation>Garder la modification</translation>
    </message>
    <message>
        <source>There is no bug capsule in the text.</source>
        <translation>Il n’y a pas de capsule de bogue dans le texte.</translation>
    </message>
    <message>
        <source>The bug capsule was made with a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>La capsule de bogue vient d’une version plus récente (%1&#xa0;; celle-ci lit jusqu’à %2). Mettez à jour le programme.</translation>
    </message>
    <message>
        <source>The run is longer than a bug capsule may be: %1 updates.</source>
        <translation>L’exécution est plus longue que ne peut l’être une capsule de bogue&#xa0;: %1 pas.</translation>
    </message>
    <message>
        <source>The run has ended, and nothing of it is left.</source>
        <translation>L’exécution est terminée, et il n’en reste rien.</translation>
    </message>
    <message>
        <source>Edits of the run</source>
        <translation>Modifications pendant l’exécution</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n changes</source>
        <translation>
            <numerusform>Garder %n modification</numerusform>
            <numerusform>Garder %n modifications</numerusform>
        </translation>
    </message>
    <message>
        <source>The wall is solid inside, where ship or payload start: it was drawn clockwise. Reverse it to make a cave of the rock.</source>
        <translation>Le mur est plein à l’intérieur, là où commencent le vaisseau ou la charge : il a été dessiné dans le sens horaire. Inversez-le pour faire du rocher une grotte.</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>%1 ne peut pas être ouvert.</translation>
    </message>
    <message>
        <source>The file is not sound XML: line %1, column %2: %3</source>
        <translation>Le fichier n’est pas du XML correct : ligne %1, colonne %2 : %3</translation>
    </message>
    <message>
        <source>Elements of the file lie more than %1 deep in one another. Ungroup some of them, and try again.</source>
        <translation>Des éléments du fichier sont imbriqués sur plus de %1 niveaux. Dégroupez-en quelques-uns et réessayez.</translation>
    </message>
    <message>
        <source>The file draws more than %1 pieces, which is more than can be imported. Take out what the level does not need, and try again.</source>
        <translation>Le fichier dessine plus de %1 éléments, plus qu’il n’est possible d’importer. Retirez ce dont le niveau n’a pas besoin et réessayez.</translation>
    </message>
    <message>
        <source>Drag: move · Shift + drag: move the pivot, about which it turns</source>
        <translation>Glisser : déplacer · Maj + glisser : déplacer le pivot, autour duquel il tourne</translation>
    </message>
    <message>
        <source>The file “%1” is too large: at most %2 can be read.</source>
        <translation>Le fichier « %1 » est trop grand : %2 au plus peuvent être lus.</translation>
    </message>
    <message>
        <source>This is too large: at most %1 can be read.</source>
        <translation>C’est trop grand : %1 au plus peuvent être lus.</translation>
    </message>
    <message>
        <source>The file is empty. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Le fichier est vide. Récupérez-le de nouveau, ou prenez-en une copie dans une sauvegarde.</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8 from here on: it is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>À partir d’ici, le fichier n’est pas du texte UTF-8 : il est endommagé ou d’une autre nature. Récupérez-le de nouveau, ou prenez-en une copie dans une sauvegarde.</translation>
    </message>
    <message>
        <source>There is a zero byte here, which text cannot hold: the file is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>Il y a ici un octet nul, impossible dans un texte : le fichier est endommagé ou d’une autre nature. Récupérez-le de nouveau, ou prenez-en une copie dans une sauvegarde.</translation>
    </message>
    <message>
        <source>The file ends too early: a bracket, a brace or a quotation mark is not closed. Perhaps it was not copied as a whole; fetch it again.</source>
        <translation>Le fichier se termine trop tôt : un crochet, une accolade ou un guillemet n’est pas fermé. Il n’a peut-être pas été copié en entier ; récupérez-le de nouveau.</translation>
    </message>
    <message>
        <source>Neither of the two bodies can be moved by the connector; one should be dynamic.</source>
        <translation>Le connecteur ne peut déplacer aucun des deux corps ; l’un devrait être dynamique.</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1 : %2</translation>
    </message>
    <message>
        <source>This is not a recorded flight. “Save Flight…” makes one of a run.</source>
        <translation>Ce n’est pas un vol enregistré. « Enregistrer le vol… » en crée un à partir d’une exécution.</translation>
    </message>
    <message>
        <source>Line %2: “%1” is missing or not what a recorded flight has there. Correct it in a text editor, or save the flight again.</source>
        <translation>Ligne %2 : « %1 » manque ou n’est pas ce qu’un vol enregistré contient à cet endroit. Corrigez-le dans un éditeur de texte, ou enregistrez le vol de nouveau.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is none that a recorded flight has. Take it out; if a newer version wrote it, update the program.</source>
        <translation>Ligne %2 : un vol enregistré n’a pas de champ « %1 ». Retirez-le ; si une version plus récente l’a écrit, mettez le programme à jour.</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is given a second time. Take one of the two out.</source>
        <translation>Ligne %2 : le champ « %1 » est donné une seconde fois. Retirez l’un des deux.</translation>
    </message>
    <message>
        <source>The flight was saved by a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>Le vol a été enregistré par une version plus récente (%1 ; celle-ci lit jusqu’à %2). Veuillez mettre le programme à jour.</translation>
    </message>
    <message>
        <source>The flight is longer than %1 updates, so it cannot be flown again. Save a shorter one.</source>
        <translation>Le vol dure plus de %1 mises à jour et ne peut donc pas être rejoué. Enregistrez-en un plus court.</translation>
    </message>
    <message>
        <source>The bug capsule is not whole: its last line is missing. Copy it again, from its first line to its last.</source>
        <translation>La capsule de bogue n’est pas entière : sa dernière ligne manque. Copiez-la de nouveau, de la première ligne à la dernière.</translation>
    </message>
    <message>
        <source>The bug capsule has been changed or damaged on its way. Copy it again where it was made.</source>
        <translation>La capsule de bogue a été modifiée ou endommagée en chemin. Copiez-la de nouveau là où elle a été faite.</translation>
    </message>
    <message>
        <source>The bug capsule cannot be understood at “%1”. Ask for a new one.</source>
        <translation>La capsule de bogue est incompréhensible à « %1 ». Demandez-en une nouvelle.</translation>
    </message>
    <message>
        <source>The level in the bug capsule cannot be read, so ask for a new one. Line %1 of it: %2</source>
        <translation>Le niveau de la capsule de bogue ne peut pas être lu ; demandez-en une nouvelle. Sa ligne %1 : %2</translation>
    </message>
    <message>
        <source>The run is larger than a bug capsule may be: %1.</source>
        <translation>L’exécution dépasse la taille permise d’une capsule de bogue : %1.</translation>
    </message>
    <message>
        <source>there is no such file; it may have been moved</source>
        <translation>ce fichier n’existe pas ; il a peut-être été déplacé</translation>
    </message>
    <message>
        <source>you do not have the permission; ask its owner for it</source>
        <translation>vous n’avez pas l’autorisation ; demandez-la à son propriétaire</translation>
    </message>
    <message>
        <source>the system does not permit it</source>
        <translation>le système ne le permet pas</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>c’est un dossier</translation>
    </message>
    <message>
        <source>what should be its folder is a file</source>
        <translation>ce qui devrait être son dossier est un fichier</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>ce n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>son nom est trop long</translation>
    </message>
    <message>
        <source>the disk does not answer as it should; copy what it holds</source>
        <translation>le disque ne répond pas comme il le devrait ; copiez ce qu’il contient</translation>
    </message>
    <message>
        <source>no place could be made there</source>
        <translation>aucun emplacement n’a pu y être créé</translation>
    </message>
    <message>
        <source>Change “%1” of the level</source>
        <translation>Modifier « %1 » du niveau</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>Modifier « %1 »</translation>
    </message>
    <message numerus="yes">
        <source>Change “%1” of %n objects</source>
        <translation>
            <numerusform>Modifier « %1 » de %n objet</numerusform>
            <numerusform>Modifier « %1 » de %n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>“%2” is on its way through a one-way wall of “%1”, from %3; %4 to %5; %6: it came from behind, and touches nothing until all of it is in front.</source>
        <translation>« %2 » traverse un mur à sens unique de « %1 », de %3 ; %4 à %5 ; %6 : il est venu de derrière et ne touche rien tant qu’il n’est pas tout entier devant.</translation>
    </message>
    <message>
        <source>“%2” is behind a one-way wall of “%1”, from %3; %4 to %5; %6, which is open from there.</source>
        <translation>« %2 » est derrière un mur à sens unique de « %1 », de %3 ; %4 à %5 ; %6, qui est ouvert de ce côté.</translation>
    </message>
    <message>
        <source>1 node selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Escape: select none</source>
        <translation>1 nœud sélectionné · glisser : déplacer · flèches : pousser · Suppr : supprimer · Maj+B : couper · Échap : ne rien sélectionner</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · release: done · Escape: cancel</source>
        <translation>Nœuds sélectionnés : %1 · relâcher : terminé · Échap : annuler</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · draw around the nodes · release: done · Escape: cancel</source>
        <translation>Nœuds sélectionnés : %1 · entourer les nœuds · relâcher : terminé · Échap : annuler</translation>
    </message>
    <message>
        <source>Cuts: %1 · release: cut · Shift: 15° · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Coupes : %1 · relâcher : couper · Maj : 15° · Ctrl : accrochage désactivé/activé · Échap : annuler</translation>
    </message>
    <message>
        <source>Pivot at %1; %2 m · Ctrl: snap off/on · Escape: cancel</source>
        <translation>Pivot à %1 ; %2 m · Ctrl : accrochage désactivé/activé · Échap : annuler</translation>
    </message>
    <message>
        <source>Locked: clicks and drags go past it</source>
        <translation>Verrouillé : clics et glissements l’ignorent</translation>
    </message>
    <message>
        <source>%1 selected · locked, so nothing changes it · Escape: select nothing</source>
        <translation>%1 sélectionné(s) · verrouillé, rien ne le modifie · Échap : ne rien sélectionner</translation>
    </message>
    <message>
        <source>A body without a name is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>Un corps sans nom n’est pas fait que de polygones. Seuls des polygones peuvent être unis, soustraits et intersectés.</translation>
    </message>
</context>
<context>
    <name>spacetow::ArrayBar</name>
    <message>
        <source>Copies</source>
        <translation>Copies</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Turn copies</source>
        <translation>Copies tournées</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Make the copies (Enter)</source>
        <translation>Faire les copies (Entrée)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Make no copies (Escape)</source>
        <translation>Ne pas faire de copies (Échap)</translation>
    </message>
    <message>
        <source>Radial array</source>
        <translation>Réseau circulaire</translation>
    </message>
    <message>
        <source>Linear array</source>
        <translation>Réseau linéaire</translation>
    </message>
    <message>
        <source>Center x</source>
        <translation>Centre x</translation>
    </message>
    <message>
        <source>Step x</source>
        <translation>Pas x</translation>
    </message>
    <message>
        <source>y</source>
        <comment>of a center or step</comment>
        <translation>y</translation>
    </message>
    <message>
        <source>Select what is to be copied.</source>
        <translation>Sélectionnez ce qui est à copier.</translation>
    </message>
    <message>
        <source>Of a ship, a payload and a finish a level has one: there is nothing to copy.</source>
        <translation>Un niveau n’a qu’un vaisseau, une charge et une arrivée&#xa0;: il n’y a rien à copier.</translation>
    </message>
    <message>
        <source>That would be %1 objects; an array may have %2. Make fewer copies.</source>
        <translation>Cela ferait %1 objets&#xa0;; un réseau peut en avoir %2. Faites moins de copies.</translation>
    </message>
</context>
<context>
    <name>spacetow::Canvas</name>
    <message>
        <source>Drawing board</source>
        <translation>Zone de dessin</translation>
    </message>
    <message>
        <source>Drawing board, running</source>
        <translation>Zone de dessin, en marche</translation>
    </message>
</context>
<context>
    <name>spacetow::ColorField</name>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
</context>
<context>
    <name>spacetow::DifferencePanel</name>
    <message>
        <source>&amp;Compare With…</source>
        <translation>&amp;Comparer avec…</translation>
    </message>
    <message>
        <source>Ta&amp;ke Over</source>
        <translation>&amp;Reprendre</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>&amp;Finir</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>Makes the selected objects as they are in the other level</source>
        <translation>Rendre les objets sélectionnés tels qu’ils sont dans l’autre niveau</translation>
    </message>
    <message>
        <source>Ends comparing; the level stays as it is</source>
        <translation>Finir la comparaison&#xa0;; le niveau reste tel quel</translation>
    </message>
    <message>
        <source>Nothing is compared. Choose a level file to see what is different from it.</source>
        <translation>Rien n’est comparé. Choisissez un fichier de niveau pour voir ce qui en diffère.</translation>
    </message>
    <message>
        <source>Comparing with %1…</source>
        <translation>Comparaison avec %1…</translation>
    </message>
    <message>
        <source>Nothing is different from %1.</source>
        <translation>Rien ne diffère de %1.</translation>
    </message>
    <message numerus="yes">
        <source>%n differences from %1</source>
        <translation>
            <numerusform>%n différence avec %1</numerusform>
            <numerusform>%n différences avec %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::DiskChanges</name>
    <message>
        <source>%1 is no longer there: it was deleted, moved or renamed. Your level is still here.</source>
        <translation>%1 n’est plus là&#xa0;: il a été supprimé, déplacé ou renommé. Votre niveau est toujours ici.</translation>
    </message>
    <message>
        <source>Save Again</source>
        <translation>Réenregistrer</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>%1 was changed by another program and has been loaded anew. Undo takes that back.</source>
        <translation>%1 a été modifié par un autre programme et rechargé. Annuler ramène l’état d’avant.</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and you have changed it here.</source>
        <translation>%1 a été modifié par un autre programme, et vous l’avez modifié ici.</translation>
    </message>
    <message>
        <source>%1 was changed by another program and cannot be read any more. Your level is still here.</source>
        <translation>%1 a été modifié par un autre programme et n’est plus lisible. Votre niveau est toujours ici.</translation>
    </message>
    <message>
        <source>Not saved: %1 was changed by another program since you opened it, and saving would overwrite that.</source>
        <translation>Non enregistré&#xa0;: un autre programme a modifié %1 depuis que vous l’avez ouvert&#xa0;; enregistrer écraserait cela.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Garder le mien</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
</context>
<context>
    <name>spacetow::EntryBox</name>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
</context>
<context>
    <name>spacetow::Exchange</name>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>Mémoire insuffisante pour une image de cette taille.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Drawings and maps (*.svg *.tmx *.tmj *.json);;All files (*)</source>
        <translation>Dessins et cartes (*.svg *.tmx *.tmj *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>PNG pictures (*.png);;SVG drawings (*.svg)</source>
        <translation>Images PNG (*.png);;Dessins SVG (*.svg)</translation>
    </message>
    <message>
        <source>%1 was imported as a whole.</source>
        <translation>%1 a été importé en entier.</translation>
    </message>
    <message>
        <source>%1 was imported, but:</source>
        <translation>%1 a été importé, mais&#xa0;:</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
    <message>
        <source>The picture was written to %1.</source>
        <translation>L’image a été écrite dans %1.</translation>
    </message>
    <message>
        <source>The screenshot was written to %1.</source>
        <translation>La capture d’écran a été écrite dans %1.</translation>
    </message>
    <message>
        <source>%1 was not imported.</source>
        <translation>%1 n’a pas été importé.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExplainPanel</name>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Combien</translation>
    </message>
    <message>
        <source>Explanation of the selection</source>
        <translation>Explication de la sélection</translation>
    </message>
    <message>
        <source>Everything. Select one object to see what moves it, or two to hear why they do not collide.</source>
        <translation>Tout. Sélectionnez un objet pour voir ce qui le meut, ou deux pour savoir pourquoi ils ne se heurtent pas.</translation>
    </message>
    <message>
        <source>Why do these two not collide?</source>
        <translation>Pourquoi ces deux-là ne se heurtent-ils pas&#xa0;?</translation>
    </message>
    <message>
        <source>Select one object, or two.</source>
        <translation>Sélectionnez un objet, ou deux.</translation>
    </message>
    <message>
        <source>“%1” is not part of the simulation.</source>
        <translation>«&#xa0;%1&#xa0;» ne fait pas partie de la simulation.</translation>
    </message>
    <message>
        <source>At least one of them is no body in the simulation.</source>
        <translation>Au moins l’un des deux n’est pas un corps de la simulation.</translation>
    </message>
</context>
<context>
    <name>spacetow::ExportBar</name>
    <message>
        <source>Export picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>Whole level</source>
        <translation>Niveau entier</translation>
    </message>
    <message>
        <source>What is in view</source>
        <translation>Partie visible</translation>
    </message>
    <message>
        <source>What of the level the picture shows</source>
        <translation>Ce que l’image montre du niveau</translation>
    </message>
    <message>
        <source>Pixels of the picture for a metre of the level.</source>
        <translation>Pixels de l’image par mètre du niveau.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>Leave the ground of the picture out</source>
        <translation>Omettre le fond de l’image</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Draw the grid as well</source>
        <translation>Dessiner aussi la grille</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Choose a file, PNG or SVG (Enter)</source>
        <translation>Choisir un fichier, PNG ou SVG (Entrée)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Write no picture (Escape)</source>
        <translation>N’écrire aucune image (Échap)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>There is nothing to be seen, or the picture would be too large: at most 16,384 pixels a side and 67 million in all. Choose another scale.</source>
        <translation>Il n’y a rien à voir, ou l’image serait trop grande&#xa0;: au plus 16&#x202f;384 pixels par côté et 67 millions en tout. Choisissez une autre échelle.</translation>
    </message>
</context>
<context>
    <name>spacetow::Finder</name>
    <message>
        <source>Find actions, levels, objects and problems</source>
        <translation>Trouver actions, niveaux, objets et problèmes</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Trouvé</translation>
    </message>
    <message>
        <source>&gt; actions · / levels · @ objects · ! problems · Enter: take · Esc: close</source>
        <translation>&gt; actions · / niveaux · @ objets · ! problèmes · Entrée&#xa0;: prendre · Échap&#xa0;: fermer</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>Rien ne porte ce nom.</translation>
    </message>
</context>
<context>
    <name>spacetow::FlightsPanel</name>
    <message>
        <source>No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or cave.NAME.replay.json in the same folder.</source>
        <translation>Aucun vol n’est enregistré à côté de ce niveau. Un vol de cave.json est un fichier cave.replay.json ou cave.NAME.replay.json dans le même dossier.</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>Vols</translation>
    </message>
</context>
<context>
    <name>spacetow::Form</name>
    <message>
        <source>Fold or unfold this section</source>
        <translation>Replier ou déplier cette section</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>Valeur par défaut</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>Valeur par défaut&#xa0;: %1</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>Stars</source>
        <translation>Étoiles</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>Uni</translation>
    </message>
    <message>
        <source>%1 of the %2 selected objects have this.</source>
        <translation>%1 des %2 objets sélectionnés ont cela.</translation>
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
        <translation>Nom</translation>
    </message>
    <message>
        <source>X of the guide</source>
        <translation>X du guide</translation>
    </message>
    <message>
        <source>Y of the guide</source>
        <translation>Y du guide</translation>
    </message>
    <message>
        <source>Angle of the guide</source>
        <translation>Angle du guide</translation>
    </message>
    <message>
        <source>Name of the guide</source>
        <translation>Nom du guide</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>Supprimer ce guide</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryModel</name>
    <message numerus="yes">
        <source>%n older changes that can no longer be undone</source>
        <translation>
            <numerusform>%n ancienne modification qui ne peut plus être annulée</numerusform>
            <numerusform>%n anciennes modifications qui ne peuvent plus être annulées</numerusform>
        </translation>
    </message>
    <message>
        <source>present state</source>
        <translation>état actuel</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>annulé</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>enregistré</translation>
    </message>
    <message>
        <source>Saved: the file holds this state</source>
        <translation>Enregistré&#xa0;: le fichier contient cet état</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>Click to go back, or forward again, to the state after an edit</source>
        <translation>Cliquer pour revenir en arrière, ou en avant, à l’état suivant une modification</translation>
    </message>
</context>
<context>
    <name>spacetow::ImportBar</name>
    <message>
        <source>Progress of the import</source>
        <translation>Progression de l’import</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importer</translation>
    </message>
    <message>
        <source>Add what is shown to the level (Enter)</source>
        <translation>Ajouter au niveau ce qui est affiché (Entrée)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Leave the level as it was (Escape)</source>
        <translation>Laisser le niveau tel qu’il était (Échap)</translation>
    </message>
    <message>
        <source>What a unit of the file is: a pixel of a drawing, a pixel of a map.</source>
        <translation>Ce que vaut une unité du fichier&#xa0;: un pixel d’un dessin, un pixel d’une carte.</translation>
    </message>
    <message>
        <source>How far straight segments may stray from a curve.</source>
        <translation>De combien des segments droits peuvent s’écarter d’une courbe.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Two-way walls</source>
        <translation>Lignes à double sens</translation>
    </message>
    <message>
        <source>One-way walls</source>
        <translation>Murs à sens unique</translation>
    </message>
    <message>
        <source>What lines without a fill become</source>
        <translation>Ce que deviennent les lignes sans remplissage</translation>
    </message>
    <message>
        <source>Fills as polygons</source>
        <translation>Pleins en polygones</translation>
    </message>
    <message>
        <source>Fills as walls</source>
        <translation>Pleins en murs</translation>
    </message>
    <message>
        <source>What filled shapes become</source>
        <translation>Ce que deviennent les formes pleines</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>Nouveau calque</translation>
    </message>
    <message>
        <source>Put all of it into a new layer, named like the file</source>
        <translation>Mettre le tout dans un nouveau calque, nommé comme le fichier</translation>
    </message>
    <message>
        <source>Center in view</source>
        <translation>Centrer dans la vue</translation>
    </message>
    <message>
        <source>Put it into the middle of the view, else where the file has it</source>
        <translation>Le mettre au milieu de la vue, sinon là où il est dans le fichier</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <source>%1 objects, %2 vertices, %3 × %4 m</source>
        <translation>%1 objets, %2 sommets, %3 × %4 m</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
</context>
<context>
    <name>spacetow::Inspector</name>
    <message>
        <source>A group cannot be put into itself.</source>
        <translation>Un groupe ne peut être mis dans lui-même.</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>Which shape the fields of shapes speak of</source>
        <translation>De quelle forme parlent les champs de forme</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>Rien n’est sélectionné.</translation>
    </message>
    <message numerus="yes">
        <source>All %n shapes</source>
        <translation>
            <numerusform>%n forme</numerusform>
            <numerusform>Les %n formes</numerusform>
        </translation>
    </message>
    <message>
        <source>Shape %1: %2</source>
        <translation>Forme %1&#xa0;: %2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n nodes selected</source>
        <translation>
            <numerusform>%1, %n nœud sélectionné</numerusform>
            <numerusform>%1, %n nœuds sélectionnés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n objet</numerusform>
            <numerusform>%n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Cela sortirait des limites du champ&#xa0;: rien n’a changé.</translation>
    </message>
    <message numerus="yes">
        <source>%n of the values would leave the range of the field, so nothing has changed.</source>
        <translation>
            <numerusform>%n des valeurs sortirait des limites du champ&#xa0;: rien n’a changé.</numerusform>
            <numerusform>%n des valeurs sortiraient des limites du champ&#xa0;: rien n’a changé.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::KeyEditor</name>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>Trouver une action ou une touche</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>Personnel</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>Jeu de touches</translation>
    </message>
    <message>
        <source>Take all keys from a program that you know</source>
        <translation>Reprendre toutes les touches d’un programme connu</translation>
    </message>
    <message>
        <source>Keys as &amp;in</source>
        <translation>Jeu &amp;de touches</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Action</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importer…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exporter…</translation>
    </message>
    <message>
        <source>Reset &amp;All</source>
        <translation>&amp;Tout par défaut</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>Take back the last change of keys</source>
        <translation>Annuler la dernière modification de touches</translation>
    </message>
    <message>
        <source>&amp;Take It Over</source>
        <translation>Re&amp;prendre</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Pa&amp;r défaut</translation>
    </message>
    <message>
        <source>Give this action the keys that it came with</source>
        <translation>Rendre à cette action ses touches d’origine</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>%1 leads to “%2” (%3).</source>
        <translation>%1 mène à «&#xa0;%2&#xa0;» (%3).</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now, and no longer to “%3”.</source>
        <translation>%1 mène maintenant à «&#xa0;%2&#xa0;», et plus à «&#xa0;%3&#xa0;».</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now.</source>
        <translation>%1 mène maintenant à «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>Touches (*.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Import Keys</source>
        <translation>Importer les touches</translation>
    </message>
    <message>
        <source>Export Keys</source>
        <translation>Exporter les touches</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>Impossible de lire «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>“%1” is too large to be a file of keys.</source>
        <translation>«&#xa0;%1&#xa0;» est trop gros pour un fichier de touches.</translation>
    </message>
    <message>
        <source>Nothing was taken from “%1”.</source>
        <translation>Rien n’a été repris de «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now.</source>
        <translation>Ce sont maintenant les touches de «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now. Nothing is called %2 here.</source>
        <translation>Ce sont maintenant les touches de «&#xa0;%1&#xa0;». Rien ne s’appelle %2 ici.</translation>
    </message>
    <message>
        <source>Wrote all keys to “%1”.</source>
        <translation>Touches écrites dans «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>“%1” cannot be written: %2.</source>
        <translation>Impossible d’écrire «&#xa0;%1&#xa0;»&#xa0;: %2.</translation>
    </message>
    <message>
        <source>This key cannot be changed, so that there is always a way out of the game.</source>
        <translation>Cette touche ne peut pas être changée, afin qu’il y ait toujours un moyen de quitter le jeu.</translation>
    </message>
</context>
<context>
    <name>spacetow::KeyRecorder</name>
    <message>
        <source>Press a key</source>
        <translation>Taper une touche</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>Nouvelle touche</translation>
    </message>
</context>
<context>
    <name>spacetow::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Search: a word, or a key as it is written</source>
        <translation>Rechercher : un mot, ou une touche comme elle s’écrit</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>No key does anything of that name.</source>
        <translation>Aucune touche ne fait quoi que ce soit de ce nom.</translation>
    </message>
</context>
<context>
    <name>spacetow::Legend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>Légende des superpositions</translation>
    </message>
    <message>
        <source>Hide the legend</source>
        <translation>Masquer la légende</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>Désactiver</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Choisir une autre couleur</translation>
    </message>
    <message>
        <source>What is too small at this zoom is not drawn</source>
        <translation>Ce qui est trop petit à ce zoom n’est pas dessiné</translation>
    </message>
    <message>
        <source>Names that would lie on others are left out</source>
        <translation>Les noms qui en recouvriraient d’autres sont omis</translation>
    </message>
</context>
<context>
    <name>spacetow::LevelPanel</name>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>Cela sortirait des limites du champ&#xa0;: rien n’a changé.</translation>
    </message>
</context>
<context>
    <name>spacetow::MainWindow</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>There is nothing on the clipboard that can be pasted here.</source>
        <translation>Rien dans le presse-papiers ne peut être collé ici.</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 enregistré</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>%1 relu</translation>
    </message>
    <message>
        <source>About SpaceTow Studio</source>
        <translation>À propos de SpaceTow Studio</translation>
    </message>
    <message>
        <source>SpaceTow Studio %1</source>
        <translation>SpaceTow Studio %1</translation>
    </message>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.

Free software under the MIT license. Made with Qt %1 and Eigen.</source>
        <translation>Dessinez des niveaux et volez-y&#xa0;: éditeur de niveaux et bac à sable physique.

Logiciel libre sous licence MIT. Fait avec Qt %1 et Eigen.</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Was open at the end of the last run, but is gone: %1</source>
        <translation>Ouvert à la fin de la dernière session, mais disparu&#xa0;: %1</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <translation>fourni avec le programme</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message numerus="yes">
        <source>The level has %n errors and may not play as it should; see Problems.</source>
        <translation>
            <numerusform>Le niveau a %n erreur et peut ne pas se jouer comme prévu&#xa0;; voir Problèmes.</numerusform>
            <numerusform>Le niveau a %n erreurs et peut ne pas se jouer comme prévu&#xa0;; voir Problèmes.</numerusform>
        </translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>won</source>
        <translation>gagné</translation>
    </message>
    <message>
        <source>crashed</source>
        <translation>écrasé</translation>
    </message>
    <message>
        <source>game over</source>
        <translation>fin de partie</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>en jeu</translation>
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
        <translation>Nouveau niveau</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>%1 ouvert</translation>
    </message>
    <message>
        <source>No level is open · arrows, Tab and Enter choose one</source>
        <translation>Aucun niveau ouvert · flèches, Tab et Entrée en choisissent un</translation>
    </message>
    <message>
        <source>snaps to: %1</source>
        <translation>s’aimante à&#xa0;: %1</translation>
    </message>
    <message>
        <source>Nothing was left unsaved.</source>
        <translation>Rien n’était resté non enregistré.</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>Principale</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>Aucun fichier</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>&amp;Effacer la liste</translation>
    </message>
    <message>
        <source>Take back the level as it was saved then, as one edit; its file stays as it is</source>
        <translation>Reprendre le niveau tel qu’enregistré alors, en une seule modification&#xa0;; son fichier reste tel quel</translation>
    </message>
    <message>
        <source>No former versions yet</source>
        <translation>Pas encore de versions antérieures</translation>
    </message>
    <message>
        <source>Select &amp;Under Pointer</source>
        <translation>Sélectionner sous le &amp;pointeur</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Fichiers récen&amp;ts</translation>
    </message>
    <message>
        <source>&amp;Backups</source>
        <translation>Sauve&amp;gardes</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>O&amp;verlays</source>
        <translation>Superposi&amp;tions</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>Ai&amp;mantation</translation>
    </message>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>&amp;Pas de grille</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>Sous-g&amp;rille</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>In&amp;sertion</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>&amp;Objet</translation>
    </message>
    <message>
        <source>&amp;Order</source>
        <translation>&amp;Ordre</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>Align&amp;er</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>&amp;Transformer</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>&amp;Chemin</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>&amp;Niveau</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Jeu</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>Fenêt&amp;re</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>Should the program end all of a sudden, what is not saved will be lost:</source>
        <translation>Si le programme s’arrêtait brutalement, ce qui n’est pas enregistré serait perdu&#xa0;:</translation>
    </message>
    <message>
        <source>%1 is open in another window too. What is saved there will arrive here.</source>
        <translation>%1 est aussi ouvert dans une autre fenêtre. Ce qui y est enregistré arrivera ici.</translation>
    </message>
    <message>
        <source>Texts in this language from now on, in all windows</source>
        <translation>Textes dans cette langue désormais, dans toutes les fenêtres</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>Lan&amp;gue</translation>
    </message>
    <message>
        <source>The game was ended: so many bodies lie in the same place that the computer&apos;s memory would not hold what happens between them. Move them apart, and play again.</source>
        <translation>Le jeu a été arrêté : tant de corps se trouvent au même endroit que la mémoire de l’ordinateur ne suffirait pas à ce qui se passe entre eux. Écartez-les, puis rejouez.</translation>
    </message>
    <message>
        <source>The game was ended: there is not enough memory for this level. Nothing of the level is lost.</source>
        <translation>Le jeu a été arrêté : il n’y a pas assez de mémoire pour ce niveau. Rien du niveau n’est perdu.</translation>
    </message>
    <message>
        <source>what was not saved of %1</source>
        <translation>ce qui n’était pas enregistré de %1</translation>
    </message>
    <message>
        <source>Write plots</source>
        <translation>Écrire les courbes</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>Save flight</source>
        <translation>Enregistrer le vol</translation>
    </message>
    <message>
        <source>Flights (*.replay.json)</source>
        <translation>Vols (*.replay.json)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
    <message>
        <source>The plots are in “%1”.</source>
        <translation>Les courbes sont dans «&#xa0;%1&#xa0;».</translation>
    </message>
    <message>
        <source>Pulling · move: pull further · let the button go: throw</source>
        <translation>Traction · déplacer&#xa0;: tirer plus loin · relâcher le bouton&#xa0;: lancer</translation>
    </message>
    <message>
        <source>Playing a recorded flight · who steers takes over · %1: back to the editor</source>
        <translation>Lecture d’un vol enregistré · piloter, c’est prendre la main · %1&#xa0;: retour à l’éditeur</translation>
    </message>
    <message>
        <source>%1: follow the ship again</source>
        <translation>%1&#xa0;: suivre de nouveau le vaisseau</translation>
    </message>
    <message>
        <source>Playing · drag a body: pull it · wheel, right drag: move the view · %1 held: back in time · %2: back to the editor · Esc: menu</source>
        <translation>Partie en cours · glisser un corps&#xa0;: le tirer · molette, glisser avec le bouton droit&#xa0;: déplacer la vue · %1 maintenue&#xa0;: remonter le temps · %2&#xa0;: retour à l’éditeur · Échap&#xa0;: menu</translation>
    </message>
    <message>
        <source>Simulation held · click: select · drag: move · %1: go on from here · %2: next frame · %3: back to the editor</source>
        <translation>Simulation suspendue · clic&#xa0;: sélectionner · glisser&#xa0;: déplacer · %1&#xa0;: continuer d’ici · %2&#xa0;: image suivante · %3&#xa0;: retour à l’éditeur</translation>
    </message>
    <message>
        <source>Simulation running · click: select · drag: pull a body, move what stands still · %1: hold · %2: back to the editor</source>
        <translation>Simulation en marche · clic&#xa0;: sélectionner · glisser&#xa0;: tirer un corps, déplacer ce qui est immobile · %1&#xa0;: suspendre · %2&#xa0;: retour à l’éditeur</translation>
    </message>
    <message>
        <source>Here begins a new level.
%1: draw the walls of a cave, anticlockwise
%2: place ship, payload and finish
%3: play
%4, %5: draw boxes and balls
%6: simulate
%7: find everything else</source>
        <translation>Ici commence un nouveau niveau.
%1 : dessiner les murs d’une grotte, dans le sens antihoraire
%2 : placer le vaisseau, la charge et l’arrivée
%3 : jouer
%4, %5 : dessiner des caisses et des balles
%6 : simuler
%7 : trouver tout le reste</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>en simulation</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>Simuler</translation>
    </message>
    <message>
        <source>Held within an update, after iteration %1 of %2 · %3: next iteration · %4: go on from here</source>
        <translation>Arrêté dans une mise à jour, après l’itération %1 sur %2 · %3 : itération suivante · %4 : continuer d’ici</translation>
    </message>
    <message>
        <source>Held · %1: go on from here · %2: next frame · %3: previous frame · %4: back to the editor</source>
        <translation>Arrêté · %1 : continuer d’ici · %2 : image suivante · %3 : image précédente · %4 : retour à l’éditeur</translation>
    </message>
    <message>
        <source> · it will move; walls and lines stand still</source>
        <translation> · il bougera ; murs et lignes restent immobiles</translation>
    </message>
    <message>
        <source>Getting ready to run: %1 s so far · %2: leave it</source>
        <translation>Préparation de l’exécution : %1 s jusqu’ici · %2 : abandonner</translation>
    </message>
    <message>
        <source>Too much for this computer: %1 s behind real time · %2: back to the editor</source>
        <translation>Trop pour cet ordinateur : %1 s de retard sur le temps réel · %2 : retour à l’éditeur</translation>
    </message>
    <message>
        <source>Simulating the run: %1 of %2 s so far · %3: leave it</source>
        <translation>Simulation de l’exécution : %1 sur %2 s jusqu’ici · %3 : abandonner</translation>
    </message>
    <message>
        <source>Playing a recorded simulation · %1: back to the editor</source>
        <translation>Lecture d’une simulation enregistrée · %1&#xa0;: retour à l’éditeur</translation>
    </message>
    <message>
        <source>A connector is pasted together with the two bodies that it joins.</source>
        <translation>Un connecteur se colle avec les deux corps qu’il relie.</translation>
    </message>
    <message>
        <source>A level has one ship, one payload and one finish, and this one has them already.</source>
        <translation>Un niveau a un vaisseau, une charge et une arrivée, et celui-ci les a déjà.</translation>
    </message>
    <message>
        <source>Nothing that is selected has an edge at the pointer.</source>
        <translation>Rien de la sélection n’a de bord sous le pointeur.</translation>
    </message>
    <message>
        <source>Edit N&amp;odes</source>
        <translation>Éditer les n&amp;œuds</translation>
    </message>
    <message>
        <source>%1: unlock all</source>
        <translation>%1 : tout déverrouiller</translation>
    </message>
    <message>
        <source>Reading %1: %2 s so far · %3: leave it</source>
        <translation>Lecture de %1 : %2 s jusqu’ici · %3 : abandonner</translation>
    </message>
</context>
<context>
    <name>spacetow::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
</context>
<context>
    <name>spacetow::Minimap</name>
    <message>
        <source>Minimap</source>
        <translation>Mini-carte</translation>
    </message>
    <message>
        <source>Click or drag: go there · wheel: zoom · arrows: move the view</source>
        <translation>Clic ou glisser&#xa0;: y aller · molette&#xa0;: zoomer · flèches&#xa0;: déplacer la vue</translation>
    </message>
</context>
<context>
    <name>spacetow::MotionLine</name>
    <message>
        <source>Now, while it runs</source>
        <translation>À présent, en marche</translation>
    </message>
    <message>
        <source>How the body moves now, while it runs; the fields say where it starts</source>
        <translation>Comment le corps se meut à présent, en marche&#xa0;; les champs disent d’où il part</translation>
    </message>
    <message>
        <source>Now: x %1 · y %2 m · %3°</source>
        <translation>À présent&#xa0;: x %1 · y %2 m · %3°</translation>
    </message>
    <message>
        <source>%1 m/s (x %2 · y %3) · %4°/s</source>
        <translation>%1 m/s (x %2 · y %3) · %4°/s</translation>
    </message>
    <message>
        <source>Now: %1 m long, %2 m at rest</source>
        <translation>À présent&#xa0;: %1 m de long, %2 m au repos</translation>
    </message>
    <message>
        <source>pushes with %1 N</source>
        <translation>pousse avec %1 N</translation>
    </message>
    <message>
        <source>pulls with %1 N</source>
        <translation>tire avec %1 N</translation>
    </message>
    <message>
        <source>Now: not there any more</source>
        <translation>À présent&#xa0;: n’existe plus</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesDelegate</name>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Cela sortirait de la carte, qui finit à %1 m de l’origine.</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesModel</name>
    <message>
        <source>shape %1: %2</source>
        <translation>forme %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Nœud</translation>
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
        <translation>Nœuds des objets en cours</translation>
    </message>
    <message>
        <source>Double click or type to change a coordinate; with several rows selected, in all of them</source>
        <translation>Double-clic ou saisie pour changer une coordonnée&#xa0;; si plusieurs lignes sont sélectionnées, dans toutes</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Insérer</translation>
    </message>
    <message>
        <source>Insert a node halfway to the next one</source>
        <translation>Insérer un nœud à mi-chemin du suivant</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected nodes</source>
        <translation>Supprimer les nœuds sélectionnés</translation>
    </message>
</context>
<context>
    <name>spacetow::NumberField</name>
    <message>
        <source>Type a number or an expression such as 2*pi/3, 20 cm, +=0.5 or *=2 · Up, Down, wheel: step · Shift: finer · Ctrl: coarser</source>
        <translation>Saisir un nombre ou une expression comme 2*pi/3, 20 cm, +=0.5 ou *=2 · Haut, Bas, molette&#xa0;: pas · Maj&#xa0;: plus fin · Ctrl&#xa0;: plus gros</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>Exactly %1 %2</source>
        <translation>Exactement %1 %2</translation>
    </message>
    <message>
        <source>A whole number</source>
        <translation>Un nombre entier</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>Un nombre</translation>
    </message>
    <message>
        <source>%1 above %2 and up to %3</source>
        <translation>%1 supérieur à %2 et jusqu’à %3</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1 de %2 à %3</translation>
    </message>
    <message>
        <source>%1 above %2</source>
        <translation>%1 supérieur à %2</translation>
    </message>
    <message>
        <source>%1 of %2 or more</source>
        <translation>%1 d’au moins %2</translation>
    </message>
    <message>
        <source>%1, or nothing</source>
        <translation>%1, ou rien</translation>
    </message>
    <message>
        <source>The result is too large.</source>
        <translation>Le résultat est trop grand.</translation>
    </message>
    <message>
        <source>%1 is not possible: %2.</source>
        <translation>%1 est impossible&#xa0;: %2.</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>«&#xa0;%1&#xa0;» n’est pas un nombre.</translation>
    </message>
</context>
<context>
    <name>spacetow::ObjectField</name>
    <message>
        <source>There is no object with this key.</source>
        <translation>Aucun objet n’a cette clé.</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>mixte</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”; write the name or the key of another object.</source>
        <translation>Rien ici ne s’appelle «&#xa0;%1&#xa0;»&#xa0;; écrivez le nom ou la clé d’un autre objet.</translation>
    </message>
    <message>
        <source>Several objects are called “%1”; write the key of the one you mean.</source>
        <translation>Plusieurs objets s’appellent «&#xa0;%1&#xa0;»&#xa0;; écrivez la clé de celui que vous voulez.</translation>
    </message>
    <message>
        <source>Choose from a list (Down)</source>
        <translation>Choisir dans une liste (Bas)</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translation>%1, clé %2</translation>
    </message>
    <message>
        <source>Select it and bring it into the middle of the view</source>
        <translation>Le sélectionner et l’amener au milieu de la vue</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Color of the group. Click to choose another one</source>
        <translation>Couleur du groupe. Cliquer pour en choisir une autre</translation>
    </message>
    <message>
        <source>Hidden in the editor; played all the same. Click to show it</source>
        <translation>Masqué dans l’éditeur&#xa0;; joué quand même. Cliquer pour l’afficher</translation>
    </message>
    <message>
        <source>Visible. Click to hide it in the editor</source>
        <translation>Visible. Cliquer pour le masquer dans l’éditeur</translation>
    </message>
    <message>
        <source>Locked: not picked on the canvas, moved or deleted. Click to unlock it</source>
        <translation>Verrouillé&#xa0;: ni saisi dans la zone de dessin, ni déplacé, ni supprimé. Cliquer pour le déverrouiller</translation>
    </message>
    <message>
        <source>Not locked. Click to lock it against changes</source>
        <translation>Non verrouillé. Cliquer pour le protéger des modifications</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>masqué</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>visible</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillé</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>non verrouillé</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>Verrouillé</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerPanel</name>
    <message>
        <source>What is locked stays where it is; unlock it to move it.</source>
        <translation>Ce qui est verrouillé reste en place&#xa0;; déverrouillez-le pour le déplacer.</translation>
    </message>
    <message>
        <source>Find: name, kind:wall, tag:ice</source>
        <translation>Rechercher&#xa0;: nom, kind:wall, tag:ice</translation>
    </message>
    <message>
        <source>Filter of the objects</source>
        <translation>Filtre des objets</translation>
    </message>
    <message>
        <source>Choose what to find</source>
        <translation>Choisir ce qui est recherché</translation>
    </message>
    <message>
        <source>Color of the Group</source>
        <translation>Couleur du groupe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Shows the objects whose name holds these words, with their groups.
kind:wall, tag:ice, is:hidden and is:locked ask for other things; a minus before a word turns it round. Enter selects all that is found.
The list shows what is drawn on top first.</source>
        <translation>Affiche les objets dont le nom contient ces mots, avec leurs groupes.
kind:wall, tag:ice, is:hidden et is:locked demandent autre chose ; un moins devant un mot l’inverse. Entrée sélectionne tout ce qui est trouvé.
La liste montre d’abord ce qui est dessiné au-dessus.</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerView</name>
    <message>
        <source>Objects of the level</source>
        <translation>Objets du niveau</translation>
    </message>
    <message>
        <source>No object matches the filter.</source>
        <translation>Aucun objet ne correspond au filtre.</translation>
    </message>
    <message>
        <source>The level has no objects.</source>
        <translation>Le niveau n’a pas d’objets.</translation>
    </message>
</context>
<context>
    <name>spacetow::OverlayColorsDialog</name>
    <message>
        <source>&amp;Set of colors:</source>
        <translation>&amp;Jeu de couleurs :</translation>
    </message>
    <message>
        <source>&amp;Forget Own Colors</source>
        <translation>O&amp;ublier mes couleurs</translation>
    </message>
    <message>
        <source>Colors of the overlays</source>
        <translation>Couleurs des surimpressions</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>Standard</translation>
    </message>
    <message>
        <source>Okabe and Ito, safe with any color vision</source>
        <translation>Okabe et Ito, sûr pour toute vision des couleurs</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>Choisir une autre couleur</translation>
    </message>
    <message>
        <source>The color of the set again</source>
        <translation>De nouveau la couleur du jeu</translation>
    </message>
    <message>
        <source>%1: the color of the set again</source>
        <translation>%1 : de nouveau la couleur du jeu</translation>
    </message>
</context>
<context>
    <name>spacetow::PauseMenu</name>
    <message>
        <source>You made it!</source>
        <translation>Réussi&#xa0;!</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>Écrasé</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>Fin de partie</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>Reprendre</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Back to the editor</source>
        <translation>Retour à l’éditeur</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>Arrêter de jouer</translation>
    </message>
    <message>
        <source>Go on playing</source>
        <translation>Continuer à jouer</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>Recommencer le niveau</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotPanel</name>
    <message>
        <source>Quantity of the selection</source>
        <translation>Grandeur de la sélection</translation>
    </message>
    <message>
        <source>What of the selected body or connector, or of everything, is to be plotted</source>
        <translation>Ce qui doit être tracé du corps ou du connecteur sélectionné, ou de l’ensemble</translation>
    </message>
    <message>
        <source>Add curve</source>
        <translation>Ajouter une courbe</translation>
    </message>
    <message>
        <source>x against y</source>
        <translation>x en fonction de y</translation>
    </message>
    <message>
        <source>The second curve against the first, in place of all over time</source>
        <translation>La deuxième courbe en fonction de la première, au lieu de toutes en fonction du temps</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Write what is plotted into a file that spreadsheets read</source>
        <translation>Écrire ce qui est tracé dans un fichier que lisent les tableurs</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Effacer</translation>
    </message>
    <message>
        <source>Remove all curves</source>
        <translation>Supprimer toutes les courbes</translation>
    </message>
    <message>
        <source>Drift: how far energy has come from its first value, as a share of the most that was ever in motion or in springs; and momentum, as a share of the most that all bodies had</source>
        <translation>Dérive&#xa0;: de combien l’énergie s’est écartée de sa valeur initiale, en part du maximum jamais atteint en mouvement ou dans les ressorts&#xa0;; et la quantité de mouvement, en part du maximum qu’ont eu tous les corps</translation>
    </message>
    <message>
        <source>Select a body or a connector, choose a quantity and add its curve. It grows while the level is played or simulated.</source>
        <translation>Sélectionnez un corps ou un connecteur, choisissez une grandeur et ajoutez sa courbe. Elle s’allonge pendant que le niveau est joué ou simulé.</translation>
    </message>
    <message>
        <source>Remove the curve “%1”</source>
        <translation>Supprimer la courbe «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>Rien n’est en marche.</translation>
    </message>
    <message>
        <source>Energy %1 J, %2 J since the start (drift %3) · momentum %4 kg m/s (drift %5)</source>
        <translation>Énergie %1 J, %2 J depuis le début (dérive %3) · quantité de mouvement %4 kg m/s (dérive %5)</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotView</name>
    <message>
        <source>Plot</source>
        <translation>Courbes</translation>
    </message>
    <message>
        <source>Wheel: zoom · drag: move · double-click: show everything</source>
        <translation>Molette&#xa0;: zoomer · glisser&#xa0;: déplacer · double-clic&#xa0;: tout afficher</translation>
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
        <translation>Corriger</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemList</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemsPanel</name>
    <message>
        <source>Show notes: what could be tidied</source>
        <translation>Voir les notes&#xa0;: ce qui pourrait être rangé</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>Voir les avertissements</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>Voir les erreurs</translation>
    </message>
    <message>
        <source>Show the problems that are hidden in this level, too</source>
        <translation>Voir aussi les problèmes masqués dans ce niveau</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>Corriger tous les problèmes dont la correction ne change rien de voulu</translation>
    </message>
    <message>
        <source>Problems of the level</source>
        <translation>Problèmes du niveau</translation>
    </message>
    <message>
        <source>Hidden: %1</source>
        <translation>Masqués&#xa0;: %1</translation>
    </message>
    <message>
        <source>Fix all that is safe: %1</source>
        <translation>Tout corriger sans risque&#xa0;: %1</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>Vérification…</translation>
    </message>
    <message>
        <source>Nothing to complain about.</source>
        <translation>Rien à redire.</translation>
    </message>
    <message>
        <source>Nothing else: the rest is filtered out or hidden.</source>
        <translation>Rien d’autre&#xa0;: le reste est filtré ou masqué.</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>Corriger&#xa0;: %1</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>Réafficher</translation>
    </message>
    <message>
        <source>Hide it in this level</source>
        <translation>Le masquer dans ce niveau</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>Copier le texte</translation>
    </message>
    <message>
        <source>Nothing was found that would cure this by itself.</source>
        <translation>Rien n’a été trouvé qui corrigerait cela de soi-même.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfileChart</name>
    <message>
        <source>Times of the last updates</source>
        <translation>Temps des derniers pas</translation>
    </message>
    <message>
        <source>The last updates, newest at the right; the colors are those of the stages below</source>
        <translation>Les derniers pas, le plus récent à droite&#xa0;; les couleurs sont celles des étapes ci-dessous</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Times are taken while the level is played or simulated.</source>
        <translation>Les temps sont mesurés pendant que le niveau est joué ou simulé.</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfilePanel</name>
    <message>
        <source>Stage, ms</source>
        <translation>Étape, ms</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>À présent</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Moyenne</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Times and counters</source>
        <translation>Temps et compteurs</translation>
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
        <translation>Le programme s’est arrêté avec du travail non enregistré&#xa0;:</translation>
    </message>
    <message>
        <source>Not now: it is kept, and offered again</source>
        <translation>Pas maintenant&#xa0;: il est gardé, et proposé plus tard</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Beside the file as it is now:</source>
        <translation>À côté du fichier tel qu’il est&#xa0;:</translation>
    </message>
    <message>
        <source>There is no file to compare it with:</source>
        <translation>Aucun fichier auquel le comparer&#xa0;:</translation>
    </message>
    <message>
        <source>It is the same as the file.</source>
        <translation>Il est identique au fichier.</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryRow</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n objet</numerusform>
            <numerusform>%n objets</numerusform>
        </translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>jamais enregistré</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Go on with this level; its file stays as it is until you save</source>
        <translation>Continuer avec ce niveau&#xa0;; son fichier reste tel quel jusqu’à l’enregistrement</translation>
    </message>
    <message>
        <source>Do not offer this any more</source>
        <translation>Ne plus proposer ceci</translation>
    </message>
    <message>
        <source>Discarded.</source>
        <translation>Abandonné.</translation>
    </message>
    <message>
        <source>Say and show what differs from the file</source>
        <translation>Dire et montrer ce qui diffère du fichier</translation>
    </message>
</context>
<context>
    <name>spacetow::Ruler</name>
    <message>
        <source>Ruler above the drawing board</source>
        <translation>Règle au-dessus de la zone de dessin</translation>
    </message>
    <message>
        <source>Ruler beside the drawing board</source>
        <translation>Règle à côté de la zone de dessin</translation>
    </message>
    <message>
        <source>Metres; drag a horizontal guide out of the ruler</source>
        <translation>Mètres&#xa0;; tirer un guide horizontal hors de la règle</translation>
    </message>
    <message>
        <source>Metres; drag a vertical guide out of the ruler</source>
        <translation>Mètres&#xa0;; tirer un guide vertical hors de la règle</translation>
    </message>
</context>
<context>
    <name>spacetow::RulerCorner</name>
    <message>
        <source>Corner of the rulers</source>
        <translation>Coin des règles</translation>
    </message>
    <message>
        <source>Metres; drag a slanting guide out of the corner</source>
        <translation>Mètres&#xa0;; tirer un guide oblique hors du coin</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesList</name>
    <message>
        <source>Is kept only together with:
%1</source>
        <translation>N’est gardé qu’avec&#xa0;:
%1</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesPanel</name>
    <message>
        <source>Keep &amp;All</source>
        <translation>&amp;Tout garder</translation>
    </message>
    <message>
        <source>Keep &amp;Ticked</source>
        <translation>Garder les &amp;cochées</translation>
    </message>
    <message>
        <source>&amp;Discard All</source>
        <translation>Tout a&amp;bandonner</translation>
    </message>
    <message>
        <source>Changes made in this run</source>
        <translation>Modifications de cette exécution</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, each as one step that can be undone</source>
        <translation>Faire toutes ces modifications dans le niveau, chacune en une étape annulable</translation>
    </message>
    <message>
        <source>Makes those that are ticked in the level, and forgets the others</source>
        <translation>Faire dans le niveau celles qui sont cochées, et oublier les autres</translation>
    </message>
    <message>
        <source>Leaves the level as it was before the run; Undo brings the changes back</source>
        <translation>Laisser le niveau tel qu’avant l’exécution&#xa0;; Annuler ramène les modifications</translation>
    </message>
    <message numerus="yes">
        <source>%n changes were made in this run. The level is as before; keep what you like.</source>
        <translation>
            <numerusform>%n modification a été faite pendant cette exécution. Le niveau est comme avant&#xa0;; gardez-la si vous voulez.</numerusform>
            <numerusform>%n modifications ont été faites pendant cette exécution. Le niveau est comme avant&#xa0;; gardez ce que vous voulez.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing waits to be kept. What is changed in a level while it runs is listed here when the run ends.</source>
        <translation>Rien n’attend d’être gardé. Ce qui est modifié dans un niveau en marche apparaît ici à la fin de l’exécution.</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, as one step that can be undone</source>
        <translation>Apporte toutes ces modifications au niveau, en une étape annulable</translation>
    </message>
    <message>
        <source>The end of the run is undone: what was changed in it is in the level again. Redo takes it out, and lists it to be kept.</source>
        <translation>La fin de l’exécution est annulée : ce qui y a été modifié est de nouveau dans le niveau. Rétablir le retire et le liste pour être gardé.</translation>
    </message>
</context>
<context>
    <name>spacetow::ScrubLabel</name>
    <message>
        <source>Drag: change the number · Shift: a tenth as fast · Ctrl: in whole steps · Escape: take it back</source>
        <translation>Glisser&#xa0;: changer le nombre · Maj&#xa0;: dix fois plus lent · Ctrl&#xa0;: par pas entiers · Échap&#xa0;: revenir</translation>
    </message>
</context>
<context>
    <name>spacetow::StatusLine</name>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>&amp;Pas de grille</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>Sous-g&amp;rille</translation>
    </message>
    <message>
        <source>How points snap; Shift+G switches the grid, Shift+S the rest, Ctrl suspends both</source>
        <translation>Aimantation des points&#xa0;; Maj+G commute la grille, Maj+S le reste, Ctrl suspend les deux</translation>
    </message>
    <message>
        <source>Next problem (F4)</source>
        <translation>Problème suivant (F4)</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 parties</translation>
    </message>
    <message>
        <source>x %1  y %2 m</source>
        <translation>x %1  y %2 m</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n sélectionné</numerusform>
            <numerusform>%n sélectionnés</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 × %2 m</source>
        <translation>, %1 × %2 m</translation>
    </message>
    <message>
        <source>Snap %1 m</source>
        <translation>Aimant %1 m</translation>
    </message>
    <message>
        <source>Snap to objects</source>
        <translation>Aimant objets</translation>
    </message>
    <message>
        <source>Snap off</source>
        <translation>Sans aimant</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n erreur</numerusform>
            <numerusform>%n erreurs</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n avertissement</numerusform>
            <numerusform>%n avertissements</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>Aucun problème</translation>
    </message>
</context>
<context>
    <name>spacetow::TagGrid</name>
    <message>
        <source>everything</source>
        <translation>tout</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Name another of the 32 tags</source>
        <translation>Nommer une autre des 32 étiquettes</translation>
    </message>
    <message>
        <source>%1 – double-click or F2 to rename, right-click for more</source>
        <translation>%1 – double-clic ou F2 pour renommer, clic droit pour plus</translation>
    </message>
    <message>
        <source>everything except</source>
        <translation>tout sauf</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later, but for those crossed out; click for everything</source>
        <translation>Touche tout ce qui a une étiquette, même créée plus tard, sauf celles barrées&#xa0;; cliquer&#xa0;: tout</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later; click for nothing, click a tag to leave it out</source>
        <translation>Touche tout ce qui a une étiquette, même créée plus tard&#xa0;; cliquer&#xa0;: rien, cliquer une étiquette&#xa0;: l’exclure</translation>
    </message>
    <message>
        <source>Touches the marked tags only; click for everything</source>
        <translation>Touche seulement les étiquettes marquées&#xa0;; cliquer&#xa0;: tout</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Couleur…</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Sélectionner tout avec cette étiquette</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Couleur de «&#xa0;%1&#xa0;»</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixPanel</name>
    <message>
        <source>Name of the tag</source>
        <translation>Nom de l’étiquette</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>&amp;Sélectionner tout avec cette étiquette</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Renommer</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>&amp;Couleur…</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>Couleur de «&#xa0;%1&#xa0;»</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixView</name>
    <message>
        <source>Tag matrix</source>
        <translation>Matrice d’étiquettes</translation>
    </message>
    <message>
        <source>No object is “%1” or “%2”.</source>
        <translation>Aucun objet n’est «&#xa0;%1&#xa0;» ou «&#xa0;%2&#xa0;».</translation>
    </message>
    <message>
        <source>“%1” and “%2” pass through each other.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se traversent.</translation>
    </message>
    <message>
        <source>“%1” and “%2” touch each other.</source>
        <translation>«&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se touchent.</translation>
    </message>
    <message>
        <source>Some that are “%1” and “%2” touch each other.</source>
        <translation>Certains «&#xa0;%1&#xa0;» et «&#xa0;%2&#xa0;» se touchent.</translation>
    </message>
    <message>
        <source>The rules of the game say so.</source>
        <translation>Les règles du jeu le veulent.</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are “%1”; double-click to select them, right-click for more</source>
        <translation>
            <numerusform>%n objet est «&#xa0;%1&#xa0;»&#xa0;; double-clic&#xa0;: le sélectionner, clic droit&#xa0;: plus</numerusform>
            <numerusform>%n objets sont «&#xa0;%1&#xa0;»&#xa0;; double-clic&#xa0;: les sélectionner, clic droit&#xa0;: plus</numerusform>
        </translation>
    </message>
    <message>
        <source>They did touch in the last run.</source>
        <translation>Ils se sont touchés lors de la dernière exécution.</translation>
    </message>
    <message>
        <source>They met in the last run, and passed through each other.</source>
        <translation>Ils se sont rencontrés lors de la dernière exécution, et se sont traversés.</translation>
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
        <translation>À quelle vitesse le temps s’écoule</translation>
    </message>
</context>
<context>
    <name>spacetow::TimelineScale</name>
    <message>
        <source>Touch</source>
        <translation>Contact</translation>
    </message>
    <message>
        <source>Payload taken in tow</source>
        <translation>Charge prise en remorque</translation>
    </message>
    <message>
        <source>Payload let go</source>
        <translation>Charge lâchée</translation>
    </message>
    <message>
        <source>Crash</source>
        <translation>Écrasement</translation>
    </message>
    <message>
        <source>New attempt</source>
        <translation>Nouvel essai</translation>
    </message>
    <message>
        <source>Win</source>
        <translation>Victoire</translation>
    </message>
    <message>
        <source>Edit of the level</source>
        <translation>Modification du niveau</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1, à %2</translation>
    </message>
    <message>
        <source>The selected body touches something</source>
        <translation>Le corps sélectionné touche quelque chose</translation>
    </message>
    <message>
        <source>The selected body parts from something</source>
        <translation>Le corps sélectionné se sépare de quelque chose</translation>
    </message>
    <message>
        <source>Dashed on the canvas: what was to come before the run was changed. Without a ship these are the ways of the selected body and of up to %1 others.</source>
        <translation>En pointillé sur le canevas : ce qui allait venir avant que l’exécution ne soit changée. Sans vaisseau, ce sont les trajets du corps sélectionné et d’au plus %1 autres.</translation>
    </message>
</context>
<context>
    <name>spacetow::TransformBar</name>
    <message>
        <source>Transform</source>
        <translation>Transformer</translation>
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
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>Tourner de</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>Relatif</translation>
    </message>
    <message>
        <source>Move by metres and scale by percent instead of to a place and size</source>
        <translation>Déplacer en mètres et redimensionner en pour cent plutôt que vers une position et une taille</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this bar (Escape)</source>
        <translation>Fermer cette barre (Échap)</translation>
    </message>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>Cela sortirait de la carte, qui finit à %1 m de l’origine.</translation>
    </message>
</context>
<context>
    <name>spacetow::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>Accueil</translation>
    </message>
    <message>
        <source>Draw a cave, and fly your load out of it.</source>
        <translation>Dessinez une grotte, et sortez-en votre charge en volant.</translation>
    </message>
    <message>
        <source>&amp;New Level</source>
        <translation>&amp;Nouveau niveau</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Recent levels</source>
        <translation>Niveaux récents</translation>
    </message>
    <message>
        <source>Levels that come with the program; what you open is a copy</source>
        <translation>Niveaux fournis avec le programme&#xa0;; ce que vous ouvrez est une copie</translation>
    </message>
    <message>
        <source>&amp;Show this page at start and when the last level is closed</source>
        <translation>&amp;Afficher cette page au démarrage et à la fermeture du dernier niveau</translation>
    </message>
    <message>
        <source>Sandbox</source>
        <translation>Bac à sable</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Niveau</translation>
    </message>
    <message>
        <source>Sandboxes: each shows one thing that the physics does, and says what to try</source>
        <translation>Bacs à sable&#xa0;: chacun montre une chose que fait la physique, et dit quoi essayer</translation>
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
        <translation>Zoom&#xa0;: saisir un pourcentage, ou en choisir un&#xa0;; Ctrl+0 donne la taille originale</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
</TS>
