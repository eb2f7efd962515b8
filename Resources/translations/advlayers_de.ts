<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AdvLayersPreferences</name>
    <message>
        <source> deg</source>
        <translation> Grad</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation>Krümmungswinkel</translation>
    </message>
    <message>
        <source>Defaults of a new layer mesh</source>
        <translation>Vorgaben für ein neues Schichtnetz</translation>
    </message>
    <message>
        <source>Draw the layers as they grow</source>
        <translation>Die Schichten zeichnen, während sie wachsen</translation>
    </message>
    <message>
        <source>Each layer of a new mesh is this much higher than the one before it.</source>
        <translation>Jede Schicht eines neuen Netzes ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch.</source>
        <translation>Flächen, die sich in einem kleineren Winkel treffen, werden als eine Teilfläche vernetzt.</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Allgemein</translation>
    </message>
    <message>
        <source>Grow until isotropic</source>
        <translation>Wachsen, bis isotrop</translation>
    </message>
    <message>
        <source>Grows each layer of a new mesh until its height reaches the spacing along the wall.</source>
        <translation>Lässt die Schichten eines neuen Netzes wachsen, bis ihre Höhe den Abstand entlang der Wand erreicht.</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstumsfaktor</translation>
    </message>
    <message>
        <source>How often the growing mesh is drawn, at most.</source>
        <translation>Wie oft das wachsende Netz höchstens gezeichnet wird.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Meshing</source>
        <translation>Vernetzung</translation>
    </message>
    <message>
        <source>Number of layers of a new mesh; 0 grows them until the fronts close.</source>
        <translation>Zahl der Schichten eines neuen Netzes; bei 0 wachsen sie, bis die Fronten sich schließen.</translation>
    </message>
    <message>
        <source>Pictures per second</source>
        <translation>Bilder je Sekunde</translation>
    </message>
    <message>
        <source>Shows the mesh in the 3D view while it is being made.</source>
        <translation>Zeigt das Netz in der 3D-Ansicht, während es entsteht.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face.</source>
        <translation>Um wie viel sich eine Elementkante entlang einer gekrümmten Kante oder Fläche höchstens drehen darf.</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Threads für die Vernetzung; 0 nutzt alle Prozessoren. Das Netz hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>What fills the part of a new mesh that no layer reaches.</source>
        <translation>Was den Teil eines neuen Netzes füllt, den keine Schicht erreicht.</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
</context>
<context>
    <name>AdvLayers_AcceptReferences</name>
    <message>
        <source>Accept References</source>
        <translation>Referenzen annehmen</translation>
    </message>
    <message>
        <source>Takes lost references for what their names stand for now</source>
        <translation>Nimmt verlorene Referenzen für das, wofür ihre Namen jetzt stehen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Check</name>
    <message>
        <source>Check Mesh</source>
        <translation>Netz prüfen</translation>
    </message>
    <message>
        <source>Opens the results of the mesh: lost references, diagnostics, worst elements; a click leads to the place</source>
        <translation>Öffnet die Ergebnisse des Netzes: verlorene Referenzen, Meldungen, schlechteste Elemente; ein Klick führt zur Stelle</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourBy</name>
    <message>
        <source>Colour by</source>
        <translation>Einfärben nach</translation>
    </message>
    <message>
        <source>Colours the selected layer meshes, or all of the document, by one of their fields</source>
        <translation>Färbt die gewählten Schichtnetze, oder alle des Dokuments, nach einem ihrer Felder</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByAspectRatio</name>
    <message>
        <source>Aspect Ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Colours the elements by their longest side over their shortest</source>
        <translation>Färbt die Elemente nach dem Verhältnis ihrer längsten zu ihrer kürzesten Seite</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByDiagnostics</name>
    <message>
        <source>Diagnostics</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Shows the poor elements, and the places that the mesher's messages are about</source>
        <translation>Zeigt die schlechten Elemente und die Stellen, von denen die Meldungen des Vernetzers handeln</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByHeightError</name>
    <message>
        <source>Colours the elements of layers by how far their height is from the one asked for</source>
        <translation>Färbt die Elemente der Schichten danach, wie weit ihre Höhe von der verlangten abweicht</translation>
    </message>
    <message>
        <source>Height Error</source>
        <translation>Höhenfehler</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByLayer</name>
    <message>
        <source>Colours the elements by the layer that they belong to</source>
        <translation>Färbt die Elemente nach der Schicht, zu der sie gehören</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ColourByQuality</name>
    <message>
        <source>Colours the elements by their quality, from 0 to 1</source>
        <translation>Färbt die Elemente nach ihrer Qualität, von 0 bis 1</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Export</name>
    <message>
        <source>Export Mesh…</source>
        <translation>Netz exportieren…</translation>
    </message>
    <message>
        <source>Writes the mesh to a file with all of its quads, triangles and groups</source>
        <translation>Schreibt das Netz mit allen Vierecken, Dreiecken und Gruppen in eine Datei</translation>
    </message>
</context>
<context>
    <name>AdvLayers_FillVolume</name>
    <message>
        <source>Fill with Tetrahedra</source>
        <translation>Mit Tetraedern füllen</translation>
    </message>
    <message>
        <source>Fills the inside of a closed layer mesh with tetrahedra, using Gmsh or Netgen</source>
        <translation>Füllt das Innere eines geschlossenen Schichtnetzes mit Tetraedern, mit Gmsh oder Netgen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_FollowReferences</name>
    <message>
        <source>Follow References</source>
        <translation>Referenzen nachführen</translation>
    </message>
    <message>
        <source>Gives lost references the names that what was picked has now, where it is still there</source>
        <translation>Gibt verlorenen Referenzen die Namen, die das Gewählte jetzt hat, wo es noch da ist</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Group</name>
    <message>
        <source>Groups the selected faces and edges under a name, for boundary conditions: the label of the new object, which may be changed</source>
        <translation>Fasst die gewählten Flächen und Kanten unter einem Namen zusammen, für Randbedingungen: der Bezeichnung des neuen Objekts, die geändert werden kann</translation>
    </message>
    <message>
        <source>Named Group</source>
        <translation>Benannte Gruppe</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Help</name>
    <message>
        <source>Help on Advancing Layers</source>
        <translation>Hilfe zu Advancing Layers</translation>
    </message>
    <message>
        <source>Opens the manual: first steps, every setting, the method</source>
        <translation>Öffnet das Handbuch: erste Schritte, jede Einstellung, das Verfahren</translation>
    </message>
</context>
<context>
    <name>AdvLayers_LayerMesh</name>
    <message>
        <source>Creates a quad-dominant surface mesh of the selected shape or faces, with layers along its edges, or along the selected ones</source>
        <translation>Erstellt ein Flächennetz vorwiegend aus Vierecken für die ausgewählte Form oder Flächen, mit Schichten an ihren Kanten oder an den ausgewählten</translation>
    </message>
    <message>
        <source>Layer Mesh…</source>
        <translation>Schichtnetz…</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Size</name>
    <message>
        <source>Sets the size of the mesh on the selected faces and edges</source>
        <translation>Legt die Elementgröße auf den gewählten Flächen und Kanten fest</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Elementgröße</translation>
    </message>
</context>
<context>
    <name>AdvLayers_TakeOver</name>
    <message>
        <source>Makes a layer mesh with the sizes, boundary layers, regions and groups of the selected Gmsh mesh, and puts it in its place in the analysis</source>
        <translation>Erzeugt ein Schichtnetz mit den Elementgrößen, Grenzschichten, Bereichen und Gruppen des gewählten Gmsh-Netzes und setzt es in der Analyse an dessen Stelle</translation>
    </message>
    <message>
        <source>Take over from Gmsh Mesh</source>
        <translation>Von Gmsh-Netz übernehmen</translation>
    </message>
</context>
<context>
    <name>AdvLayers_ToMesh</name>
    <message>
        <source>Convert to Triangles</source>
        <translation>In Dreiecke umwandeln</translation>
    </message>
    <message>
        <source>Makes a Mesh object of the layer mesh, each quad as two triangles</source>
        <translation>Macht aus dem Schichtnetz ein Mesh-Objekt, aus jedem Viereck zwei Dreiecke</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Uncoloured</name>
    <message>
        <source>No Colours</source>
        <translation>Ohne Farben</translation>
    </message>
    <message>
        <source>Shows the elements in one colour, as FreeCAD shows a FEM mesh</source>
        <translation>Zeigt die Elemente in einer Farbe, wie FreeCAD ein FEM-Netz zeigt</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Update</name>
    <message>
        <source>Meshes the selected layer meshes again, or all of the document that are out of date</source>
        <translation>Vernetzt die gewählten Schichtnetze neu, oder alle veralteten des Dokuments</translation>
    </message>
    <message>
        <source>Update Mesh</source>
        <translation>Netz aktualisieren</translation>
    </message>
</context>
<context>
    <name>AdvLayers_Wall</name>
    <message>
        <source>Gives the selected edges, or the edges of the selected faces, layers of their own height, growth and number</source>
        <translation>Gibt den gewählten Kanten, oder den Kanten der gewählten Flächen, Schichten mit eigener Höhe, eigenem Wachstum und eigener Zahl</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
</context>
<context>
    <name>AdvancingLayers</name>
    <message>
        <source>&gt; {} mm, {} of the shape's diagonal</source>
        <translation>&gt; {} mm, {} der Diagonale der Form</translation>
    </message>
    <message>
        <source>A click shows the place; another one on the same line the next</source>
        <translation>Ein Klick zeigt die Stelle, ein weiterer auf dieselbe Zeile die nächste</translation>
    </message>
    <message>
        <source>A click shows where layers end too early, or where the first height is most off</source>
        <translation>Ein Klick zeigt, wo Schichten zu früh enden oder wo die erste Höhe am meisten abweicht</translation>
    </message>
    <message>
        <source>A named group of the selected faces and edges</source>
        <translation>Eine benannte Gruppe der gewählten Flächen und Kanten</translation>
    </message>
    <message>
        <source>A range of the colours other than that of the field</source>
        <translation>Ein anderer Bereich der Farben als der des Feldes</translation>
    </message>
    <message>
        <source>A size of their own for the selected faces, edges and vertices</source>
        <translation>Eine eigene Elementgröße für die gewählten Flächen, Kanten und Eckpunkte</translation>
    </message>
    <message>
        <source>Abaqus</source>
        <translation>Abaqus</translation>
    </message>
    <message>
        <source>Adds what is selected in the 3D view</source>
        <translation>Fügt hinzu, was in der 3D-Ansicht gewählt ist</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>All holes</source>
        <translation>Alle Löcher</translation>
    </message>
    <message>
        <source>All that are not selected</source>
        <translation>Alles, was nicht ausgewählt ist</translation>
    </message>
    <message>
        <source>Always</source>
        <translation>Immer</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>Angles from</source>
        <translation>Winkel von</translation>
    </message>
    <message>
        <source>Arcs with the radius of the selected ones</source>
        <translation>Bögen mit dem Radius der ausgewählten</translation>
    </message>
    <message>
        <source>As usual</source>
        <translation>Wie üblich</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Axis direction</source>
        <translation>Achsrichtung</translation>
    </message>
    <message>
        <source>Axis point</source>
        <translation>Achspunkt</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückseite</translation>
    </message>
    <message>
        <source>Beside other meshers</source>
        <translation>Neben anderen Vernetzern</translation>
    </message>
    <message>
        <source>Both ends</source>
        <translation>Beide Enden</translation>
    </message>
    <message>
        <source>Boundary</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>By group</source>
        <translation>Nach Gruppe</translation>
    </message>
    <message>
        <source>CFD: layers from all sharp edges</source>
        <translation>CFD: Schichten von allen scharfen Kanten</translation>
    </message>
    <message>
        <source>CGNS</source>
        <translation>CGNS</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>Cells across</source>
        <translation>Elemente quer</translation>
    </message>
    <message>
        <source>Chord deviation</source>
        <translation>Sehnenabweichung</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>Schließen Sie zuerst das offene Aufgabenfenster.</translation>
    </message>
    <message>
        <source>Closes, and leaves everything as it was before</source>
        <translation>Schließt und lässt alles, wie es vorher war</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Verdichtung</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Einfärben nach</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Farben von</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Corner</source>
        <translation>Ecke</translation>
    </message>
    <message>
        <source>Curvature angle</source>
        <translation>Krümmungswinkel</translation>
    </message>
    <message>
        <source>Cut across</source>
        <translation>Schnitt quer zu</translation>
    </message>
    <message>
        <source>Cutting the edges</source>
        <translation>Die Kanten werden geteilt</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Dichte</translation>
    </message>
    <message>
        <source>Diagnostics</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Edge</source>
        <translation>Kante</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Kanten</translation>
    </message>
    <message>
        <source>Edges as long as the selected ones</source>
        <translation>Kanten so lang wie die ausgewählten</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Edit Layer Mesh</source>
        <translation>Schichtnetz bearbeiten</translation>
    </message>
    <message>
        <source>Edit Wall, Size or Group</source>
        <translation>Wand, Größe oder Gruppe bearbeiten</translation>
    </message>
    <message>
        <source>Element edges</source>
        <translation>Elementkanten</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>End height</source>
        <translation>Endhöhe</translation>
    </message>
    <message>
        <source>Ended by</source>
        <translation>Beendet durch</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>Gleichmäßig</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>Extrude</source>
        <translation>Extrudieren</translation>
    </message>
    <message>
        <source>FEM: no layers</source>
        <translation>FEM: keine Schichten</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>Face edges</source>
        <translation>Ränder</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces of {}</source>
        <translation>Flächen von {}</translation>
    </message>
    <message>
        <source>Feature angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Finishing the core</source>
        <translation>Der Kern wird vollendet</translation>
    </message>
    <message>
        <source>First height</source>
        <translation>Erste Höhe</translation>
    </message>
    <message>
        <source>First height from y+</source>
        <translation>Erste Höhe aus y+</translation>
    </message>
    <message>
        <source>First height {} is above the size {}: it may be {} at most</source>
        <translation>Die erste Höhe {} liegt über der Größe {}: sie darf höchstens {} sein</translation>
    </message>
    <message>
        <source>First segment</source>
        <translation>Erster Abschnitt</translation>
    </message>
    <message>
        <source>First steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Strömung</translation>
    </message>
    <message>
        <source>Fluid</source>
        <translation>Fluid</translation>
    </message>
    <message>
        <source>Follow References</source>
        <translation>Referenzen nachführen</translation>
    </message>
    <message>
        <source>FreeCAD document</source>
        <translation>FreeCAD-Dokument</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>General</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Give one of first height, aspect ratio and turning angle, not several</source>
        <translation>Nur eines von erster Höhe, Seitenverhältnis und Drehwinkel angeben</translation>
    </message>
    <message>
        <source>Gmsh</source>
        <translation>Gmsh</translation>
    </message>
    <message>
        <source>Gmsh cannot fill the mesh: it moved the nodes of the surface</source>
        <translation>Gmsh kann das Netz nicht füllen: es hat die Knoten der Oberfläche verschoben</translation>
    </message>
    <message>
        <source>Gmsh cannot fill the mesh: {}</source>
        <translation>Gmsh kann das Netz nicht füllen: {}</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Growing layers</source>
        <translation>Die Schichten wachsen</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstumsfaktor</translation>
    </message>
    <message>
        <source>Height asked</source>
        <translation>Soll-Höhe</translation>
    </message>
    <message>
        <source>Height error [%]</source>
        <translation>Höhenfehler [%]</translation>
    </message>
    <message>
        <source>Height got</source>
        <translation>Ist-Höhe</translation>
    </message>
    <message>
        <source>Help on Advancing Layers</source>
        <translation>Hilfe zu Advancing Layers</translation>
    </message>
    <message>
        <source>Hides what lies beyond a plane across this axis</source>
        <translation>Verbirgt, was jenseits einer Ebene quer zu dieser Achse liegt</translation>
    </message>
    <message>
        <source>Holes by diameter</source>
        <translation>Löcher nach Durchmesser</translation>
    </message>
    <message>
        <source>How the colours are spread over their range; logarithmic needs numbers above 0</source>
        <translation>Wie die Farben über ihren Bereich verteilt sind; logarithmisch braucht Zahlen über 0</translation>
    </message>
    <message>
        <source>I-DEAS universal</source>
        <translation>I-DEAS Universal</translation>
    </message>
    <message>
        <source>Initial mesh</source>
        <translation>Ausgangsnetz</translation>
    </message>
    <message>
        <source>Inner loops of the selected faces, or of all</source>
        <translation>Innere Ränder der ausgewählten Flächen, oder aller</translation>
    </message>
    <message>
        <source>Inp elements</source>
        <translation>Elemente der .inp</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Inverted</source>
        <translation>Invertiert</translation>
    </message>
    <message>
        <source>It is the mesh of {}.</source>
        <translation>Es ist das Netz von {}.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Behalten</translation>
    </message>
    <message>
        <source>Keeps the settings, and a mesh that is finished, and closes</source>
        <translation>Behält die Einstellungen und ein fertiges Netz und schließt</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Last segment</source>
        <translation>Letzter Abschnitt</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Layer Mesh</source>
        <translation>Schichtnetz</translation>
    </message>
    <message>
        <source>Layer groups</source>
        <translation>Gruppen der Schichten</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Layers from all edges</source>
        <translation>Schichten von allen Kanten</translation>
    </message>
    <message>
        <source>Layers grow from the selected edges; with faces selected too, on these alone</source>
        <translation>Schichten wachsen von den gewählten Kanten; sind auch Flächen gewählt, nur auf diesen</translation>
    </message>
    <message>
        <source>Layers run across the selected edges, however sharply their faces meet</source>
        <translation>Schichten laufen über die gewählten Kanten hinweg, wie scharf deren Flächen auch aneinander stoßen</translation>
    </message>
    <message>
        <source>Layers run along the selected edges</source>
        <translation>Schichten laufen an den gewählten Kanten entlang</translation>
    </message>
    <message>
        <source>Leaves the panel open</source>
        <translation>Lässt das Fenster offen</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Ring</translation>
    </message>
    <message>
        <source>Lost references</source>
        <translation>Verlorene Referenzen</translation>
    </message>
    <message>
        <source>Mapped</source>
        <translation>Abgebildet</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>Entlang</translation>
    </message>
    <message>
        <source>Max elements</source>
        <translation>Höchste Elementzahl</translation>
    </message>
    <message>
        <source>Max memory</source>
        <translation>Höchster Speicher</translation>
    </message>
    <message>
        <source>Max seconds</source>
        <translation>Höchste Rechenzeit</translation>
    </message>
    <message>
        <source>Medit</source>
        <translation>Medit</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Vernetzen</translation>
    </message>
    <message>
        <source>Mesh later</source>
        <translation>Später vernetzen</translation>
    </message>
    <message>
        <source>Meshes what is out of date, puts the mesh into the document and closes</source>
        <translation>Vernetzt, was veraltet ist, legt das Netz im Dokument ab und schließt</translation>
    </message>
    <message>
        <source>Meshes with the settings below; OK then puts the mesh into the document</source>
        <translation>Vernetzt mit den Einstellungen unten; OK übernimmt das Netz danach ins Dokument</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Min size</source>
        <translation>Kleinste Größe</translation>
    </message>
    <message>
        <source>Most slivers</source>
        <translation>Flache Zellen höchstens</translation>
    </message>
    <message>
        <source>Msh version</source>
        <translation>Version der .msh</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Nastran</source>
        <translation>Nastran</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Nah</translation>
    </message>
    <message>
        <source>Neither Gmsh nor Netgen is installed: install the package gmsh, or tell FreeCAD where it is under Edit &gt; Preferences &gt; FEM &gt; Gmsh</source>
        <translation>Weder Gmsh noch Netgen ist installiert: das Paket gmsh installieren oder FreeCAD unter Bearbeiten &gt; Einstellungen &gt; FEM &gt; Gmsh sagen, wo es liegt</translation>
    </message>
    <message>
        <source>Netgen cannot fill the mesh: {}</source>
        <translation>Netgen kann das Netz nicht füllen: {}</translation>
    </message>
    <message>
        <source>Netgen cannot keep quads: install Gmsh, or split them</source>
        <translation>Netgen kann Vierecke nicht behalten: Gmsh installieren oder sie teilen</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>No layers at the selected edges</source>
        <translation>Keine Schichten an den gewählten Kanten</translation>
    </message>
    <message>
        <source>No walls yet: with Layers from all edges, layers grow from every edge. Select edges in the 3D view and press + Wall for values of their own, + Size for finer places, + Group for boundary conditions.</source>
        <translation>Noch keine Wände: mit Schichten von allen Kanten wachsen Schichten von jeder Kante. Kanten in der 3D-Ansicht auswählen und + Wand für eigene Werte drücken, + Größe für feinere Stellen, + Gruppe für Randbedingungen.</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Not meshed</source>
        <translation>Nicht vernetzt</translation>
    </message>
    <message>
        <source>Nowhere</source>
        <translation>Nirgends</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Aus</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>OpenCASCADE failed on it: {}</source>
        <translation>OpenCASCADE ist daran gescheitert: {}</translation>
    </message>
    <message>
        <source>OpenFOAM</source>
        <translation>OpenFOAM</translation>
    </message>
    <message>
        <source>OpenFOAM has no cells of second order: ask for order 1</source>
        <translation>OpenFOAM hat keine Zellen zweiter Ordnung: Ordnung 1 verlangen</translation>
    </message>
    <message>
        <source>OpenFOAM needs cells: ask for extrude or volume</source>
        <translation>OpenFOAM braucht Zellen: extrude oder volume verlangen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Übrige</translation>
    </message>
    <message>
        <source>Out of date</source>
        <translation>Veraltet</translation>
    </message>
    <message>
        <source>Outputs</source>
        <translation>Ausgaben</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Part of {} is empty: there is nothing to mesh</source>
        <translation>Part von {} ist leer: Es gibt nichts zu vernetzen</translation>
    </message>
    <message>
        <source>Patch types</source>
        <translation>Arten der Randflächen</translation>
    </message>
    <message>
        <source>Patch {patch} of {patches} · layer {layer}</source>
        <translation>Teilfläche {patch} von {patches} · Schicht {layer}</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>Periodisch</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Vorwahl</translation>
    </message>
    <message>
        <source>Preset…</source>
        <translation>Vorwahl …</translation>
    </message>
    <message>
        <source>Preview: {}</source>
        <translation>Vorschau: {}</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>Puts what is there into the document and closes</source>
        <translation>Legt im Dokument ab, was da ist, und schließt</translation>
    </message>
    <message>
        <source>Python</source>
        <translation>Python</translation>
    </message>
    <message>
        <source>Quad nodes</source>
        <translation>Knoten je Viereck</translation>
    </message>
    <message>
        <source>Quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Reading the shape</source>
        <translation>Die Form wird gelesen</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referenzen</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Verfeinerungen</translation>
    </message>
    <message>
        <source>Relative chord</source>
        <translation>Relative Sehne</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Removes the marked row</source>
        <translation>Entfernt die markierte Zeile</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Ergebnisse</translation>
    </message>
    <message>
        <source>STL</source>
        <translation>STL</translation>
    </message>
    <message>
        <source>SU2</source>
        <translation>SU2</translation>
    </message>
    <message>
        <source>SU2 files have plane domains (x, y or z constant) and volumes, no surfaces: {}</source>
        <translation>SU2-Dateien haben ebene Gebiete (x, y oder z fest) und Volumen, keine Flächen im Raum: {}</translation>
    </message>
    <message>
        <source>Salome MED</source>
        <translation>Salome MED</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>See through</source>
        <translation>Durchsehen</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswählen</translation>
    </message>
    <message>
        <source>Select faces and edges in the 3D view.</source>
        <translation>Wählen Sie Flächen und Kanten in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Select faces or edges of the meshed shape first.</source>
        <translation>Wählen Sie zuerst Flächen oder Kanten der vernetzten Form.</translation>
    </message>
    <message>
        <source>Select faces, edges and vertices in the 3D view.</source>
        <translation>Wählen Sie Flächen, Kanten und Eckpunkte in der 3D-Ansicht.</translation>
    </message>
    <message>
        <source>Select one Gmsh mesh first.</source>
        <translation>Wählen Sie zuerst ein Gmsh-Netz.</translation>
    </message>
    <message>
        <source>Select one layer mesh first.</source>
        <translation>Wählen Sie zuerst ein Schichtnetz.</translation>
    </message>
    <message>
        <source>Select one shape, not several ({}): a layer mesh is of one, which may be a compound.</source>
        <translation>Wählen Sie eine einzige Form, nicht mehrere ({}): ein Schichtnetz gehört zu einer, die ein Verbund sein darf.</translation>
    </message>
    <message>
        <source>Select the layer mesh as well: there are several.</source>
        <translation>Wählen Sie auch das Schichtnetz: es gibt mehrere.</translation>
    </message>
    <message>
        <source>Select the shape to mesh, or some of its faces, first.</source>
        <translation>Wählen Sie zuerst die Form, die zu vernetzen ist, oder einige ihrer Flächen.</translation>
    </message>
    <message>
        <source>Selected: {}</source>
        <translation>Gewählt: {}</translation>
    </message>
    <message>
        <source>Selects all edges of the selected faces</source>
        <translation>Wählt alle Kanten der gewählten Flächen</translation>
    </message>
    <message>
        <source>Selects holes, sharp edges, similar edges, groups</source>
        <translation>Wählt Löcher, scharfe Kanten, ähnliche Kanten, Gruppen</translation>
    </message>
    <message>
        <source>Selects the edges that go on from the selected ones without a corner</source>
        <translation>Wählt die Kanten, die die gewählten ohne Ecke fortsetzen</translation>
    </message>
    <message>
        <source>Selects the whole loop of the selected edges; with a face selected too, that on the face</source>
        <translation>Wählt den ganzen Ring der gewählten Kanten; ist auch eine Fläche gewählt, den auf der Fläche</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Sew tolerance</source>
        <translation>Nähtoleranz</translation>
    </message>
    <message>
        <source>Sharp edges</source>
        <translation>Scharfe Kanten</translation>
    </message>
    <message>
        <source>Shows what is behind the faces</source>
        <translation>Zeigt, was hinter den Flächen ist</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Elementgröße</translation>
    </message>
    <message>
        <source>Size growth</source>
        <translation>Größenwachstum</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Elementgrößen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glatt</translation>
    </message>
    <message>
        <source>Solvers and file formats</source>
        <translation>Löser und Dateiformate</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Stanford polygons</source>
        <translation>Stanford-Polygone</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stopped; the mesh is the one before.</source>
        <translation>Angehalten; das Netz ist das vorige.</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Wird angehalten …</translation>
    </message>
    <message>
        <source>Strict</source>
        <translation>Streng</translation>
    </message>
    <message>
        <source>Takes the marked rows off the list</source>
        <translation>Nimmt die markierten Zeilen von der Liste</translation>
    </message>
    <message>
        <source>Tangent</source>
        <translation>Tangential</translation>
    </message>
    <message>
        <source>The changes made here are not kept yet.</source>
        <translation>Die Änderungen von hier sind noch nicht übernommen.</translation>
    </message>
    <message>
        <source>The finished mesh is not in the document yet.</source>
        <translation>Das fertige Netz ist noch nicht im Dokument.</translation>
    </message>
    <message>
        <source>The mesh is out of date: settings or model have changed.</source>
        <translation>Das Netz ist veraltet: Einstellungen oder Modell haben sich geändert.</translation>
    </message>
    <message>
        <source>The mesher is still at work.</source>
        <translation>Der Vernetzer arbeitet noch.</translation>
    </message>
    <message>
        <source>The selected edges bound their faces, however smoothly these meet</source>
        <translation>Die gewählten Kanten begrenzen ihre Flächen, wie glatt diese auch aneinander stoßen</translation>
    </message>
    <message>
        <source>The shape is in error: mend it first</source>
        <translation>Die Form ist fehlerhaft: erst beheben</translation>
    </message>
    <message>
        <source>There is no mesh yet.</source>
        <translation>Es gibt noch kein Netz.</translation>
    </message>
    <message>
        <source>There is no mesh yet: press Mesh.</source>
        <translation>Es gibt noch kein Netz: Vernetzen drücken.</translation>
    </message>
    <message>
        <source>There is nothing to complain of.</source>
        <translation>Es gibt nichts zu beanstanden.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness share</source>
        <translation>Dickenanteil</translation>
    </message>
    <message>
        <source>Thickness {} is below the first height {}: {} is the least</source>
        <translation>Die Dicke {} liegt unter der ersten Höhe {}: {} ist das Mindeste</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>Triangulating</source>
        <translation>Dreiecke werden erzeugt</translation>
    </message>
    <message>
        <source>Turning angle</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>UGRID</source>
        <translation>UGRID</translation>
    </message>
    <message>
        <source>UGRID, big-endian</source>
        <translation>UGRID, Big-Endian</translation>
    </message>
    <message>
        <source>UGRID, little-endian</source>
        <translation>UGRID, Little-Endian</translation>
    </message>
    <message>
        <source>Undo would take back all of this panel.</source>
        <translation>Rückgängig nähme alles aus diesem Fenster zurück.</translation>
    </message>
    <message>
        <source>Until isotropic</source>
        <translation>Bis isotrop</translation>
    </message>
    <message>
        <source>Until they meet</source>
        <translation>Bis zum Treffen</translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktuell</translation>
    </message>
    <message>
        <source>Update automatically</source>
        <translation>Automatisch aktualisieren</translation>
    </message>
    <message>
        <source>Use this height</source>
        <translation>Diese Höhe nehmen</translation>
    </message>
    <message>
        <source>VTK legacy</source>
        <translation>VTK (alt)</translation>
    </message>
    <message>
        <source>VTK unstructured grid</source>
        <translation>VTK, unstrukturiertes Gitter</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Washers: rings about every hole</source>
        <translation>Scheiben: Ringe um jedes Loch</translation>
    </message>
    <message>
        <source>Wavefront</source>
        <translation>Wavefront</translation>
    </message>
    <message>
        <source>What is checked</source>
        <translation>Was geprüft wird</translation>
    </message>
    <message>
        <source>What the colours of the elements in the 3D view stand for</source>
        <translation>Wofür die Farben der Elemente in der 3D-Ansicht stehen</translation>
    </message>
    <message>
        <source>When the edges of the elements are drawn; near: where they are far enough apart</source>
        <translation>Wann die Kanten der Elemente gezeichnet werden; nah: wo sie weit genug auseinander liegen</translation>
    </message>
    <message>
        <source>Y plus</source>
        <translation>y+</translation>
    </message>
    <message>
        <source>a document object is needed to mesh, got {}</source>
        <translation>Zum Vernetzen wird ein Objekt eines Dokuments gebraucht, angegeben ist {}</translation>
    </message>
    <message>
        <source>a face</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a face needs a size</source>
        <translation>eine Fläche braucht eine Elementgröße</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>eine endliche Zahl</translation>
    </message>
    <message>
        <source>air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>alle Flächen</translation>
    </message>
    <message>
        <source>all layers made</source>
        <translation>alle Schichten gebaut</translation>
    </message>
    <message>
        <source>all layers {} (orange)</source>
        <translation>alle Schichten {} (orange)</translation>
    </message>
    <message>
        <source>an edge</source>
        <translation>eine Kante</translation>
    </message>
    <message>
        <source>an entry needs a size, segments, cluster or a segment at an end</source>
        <translation>ein Eintrag braucht eine Größe, Abschnitte, eine Verdichtung oder einen Abschnitt an einem Ende</translation>
    </message>
    <message>
        <source>and {} exclude each other</source>
        <translation>und {} schließen einander aus</translation>
    </message>
    <message>
        <source>another front is too near</source>
        <translation>eine andere Front ist zu nah</translation>
    </message>
    <message>
        <source>as high as wide</source>
        <translation>so hoch wie breit</translation>
    </message>
    <message>
        <source>asks for some {} elements, {} MB and {} s; {} allows {}</source>
        <translation>verlangt etwa {} Elemente, {} MB und {} s; {} erlaubt {}</translation>
    </message>
    <message>
        <source>both_ends needs a cluster</source>
        <translation>Beide Enden braucht eine Verdichtung</translation>
    </message>
    <message>
        <source>cannot be installed: {}</source>
        <translation>lässt sich nicht einrichten: {}</translation>
    </message>
    <message>
        <source>cannot be kept: one is {} times as long as high, and {} is the most; split them, or raise first_height</source>
        <translation>lassen sich nicht behalten: eines ist {}-mal so lang wie hoch, und {} ist das Höchste; teilen oder die erste Höhe vergrößern</translation>
    </message>
    <message>
        <source>cannot be overwritten: {}</source>
        <translation>lässt sich nicht überschreiben: {}</translation>
    </message>
    <message>
        <source>cannot be read: it does not end within {} s: {}</source>
        <translation>kann nicht gelesen werden: es endet nicht innerhalb von {} s: {}</translation>
    </message>
    <message>
        <source>cannot be read: it takes more than {} MB: {}</source>
        <translation>kann nicht gelesen werden: es braucht mehr als {} MB: {}</translation>
    </message>
    <message>
        <source>cannot be read: no process can be started for it: {}: {}</source>
        <translation>kann nicht gelesen werden: kein Prozess kann dafür gestartet werden: {}: {}</translation>
    </message>
    <message>
        <source>cannot be read: {}</source>
        <translation>lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>cannot be read: {}: {}</source>
        <translation>lässt sich nicht lesen: {}: {}</translation>
    </message>
    <message>
        <source>cannot be set to {}: {}</source>
        <translation>lässt sich nicht auf {} setzen: {}</translation>
    </message>
    <message>
        <source>cannot be used: {}: {}</source>
        <translation>ist nicht zu gebrauchen: {}: {}</translation>
    </message>
    <message>
        <source>cannot be written: {}</source>
        <translation>lässt sich nicht schreiben: {}</translation>
    </message>
    <message>
        <source>cannot read the job file: {}</source>
        <translation>die Auftragsdatei lässt sich nicht lesen: {}</translation>
    </message>
    <message>
        <source>cfd</source>
        <translation>CFD</translation>
    </message>
    <message>
        <source>constant</source>
        <translation>gleichmäßig</translation>
    </message>
    <message>
        <source>cuts the mesh: it lies on both sides</source>
        <translation>schneidet das Netz: es liegt auf beiden Seiten</translation>
    </message>
    <message>
        <source>does not exist: {}</source>
        <translation>gibt es nicht: {}</translation>
    </message>
    <message>
        <source>does not go with axis_direction</source>
        <translation>verträgt sich nicht mit axis_direction</translation>
    </message>
    <message>
        <source>does not go with extrude</source>
        <translation>verträgt sich nicht mit extrude</translation>
    </message>
    <message>
        <source>element {number} {where}: angles from {least:.1f}° to {largest:.1f}°</source>
        <translation>Element {number} {where}: Winkel von {least:.1f}° bis {largest:.1f}°</translation>
    </message>
    <message>
        <source>element {}: quality {:.2f}</source>
        <translation>Element {}: Qualität {:.2f}</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>expands to {} MB: {}</source>
        <translation>entpackt sich zu {} MB: {}</translation>
    </message>
    <message>
        <source>fem</source>
        <translation>FEM</translation>
    </message>
    <message>
        <source>finds no edge for {}</source>
        <translation>findet keine Kante für {}</translation>
    </message>
    <message>
        <source>first height {} (blue)</source>
        <translation>erste Höhe {} (blau)</translation>
    </message>
    <message>
        <source>first height {} mm (Reynolds number {}); the boundary layer is some {} mm thick: {} layers of growth {}</source>
        <translation>erste Höhe {} mm (Reynolds-Zahl {}); die Grenzschicht ist etwa {} mm dick: {} Schichten mit Wachstum {}</translation>
    </message>
    <message>
        <source>for Python {} and version {} is not there: {}</source>
        <translation>für Python {} und Version {} gibt es nicht: {}</translation>
    </message>
    <message>
        <source>geometric</source>
        <translation>geometrisch</translation>
    </message>
    <message>
        <source>give a model in which {} fails</source>
        <translation>ergeben ein Modell, in dem {} fehlschlägt</translation>
    </message>
    <message>
        <source>goes with axis_direction only</source>
        <translation>gehört nur zu axis_direction</translation>
    </message>
    <message>
        <source>goes with order 2 only, got 9</source>
        <translation>passt nur zur Ordnung 2, ist aber 9</translation>
    </message>
    <message>
        <source>has a member outside of itself, {}: {}</source>
        <translation>hat einen Bestandteil außerhalb seiner selbst, {}: {}</translation>
    </message>
    <message>
        <source>has a name that is too long for its folder: {}</source>
        <translation>hat einen Namen, der für seinen Ordner zu lang ist: {}</translation>
    </message>
    <message>
        <source>has no surface elements: {}</source>
        <translation>hat keine Flächenelemente: {}</translation>
    </message>
    <message>
        <source>has the unknown format {} (known: {}): {}</source>
        <translation>hat das unbekannte Format {} (bekannt: {}): {}</translation>
    </message>
    <message>
        <source>has the unknown format {} ({}): {}</source>
        <translation>hat das unbekannte Format {} ({}): {}</translation>
    </message>
    <message>
        <source>holds a number too many: {}</source>
        <translation>enthält eine Zahl zu viel: {}</translation>
    </message>
    <message>
        <source>holds no face to mesh: {}</source>
        <translation>keine Fläche zum Vernetzen: {}</translation>
    </message>
    <message>
        <source>holds the name {}, which cannot be written</source>
        <translation>der Name {} lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>holds the name {}, which ends a part of an I-DEAS file</source>
        <translation>enthält den Namen {}, der einen Teil einer I-DEAS-Datei beendet</translation>
    </message>
    <message>
        <source>holds {}, which is no face, edge or vertex</source>
        <translation>{} ist keine Fläche, keine Kante und kein Eckpunkt</translation>
    </message>
    <message>
        <source>holds {}, which is no name like {}</source>
        <translation>{} ist kein Name wie {}</translation>
    </message>
    <message>
        <source>in layer {}</source>
        <translation>in Schicht {}</translation>
    </message>
    <message>
        <source>in layers</source>
        <translation>in Schichten</translation>
    </message>
    <message>
        <source>in the core</source>
        <translation>im Kern</translation>
    </message>
    <message>
        <source>in {}</source>
        <translation>in {}</translation>
    </message>
    <message>
        <source>is a folder: {}</source>
        <translation>ist ein Ordner: {}</translation>
    </message>
    <message>
        <source>is a name that the mesh itself gives to a group</source>
        <translation>diesen Namen gibt das Netz selbst einer Gruppe</translation>
    </message>
    <message>
        <source>is damaged, or no FreeCAD document: {}: {}</source>
        <translation>ist beschädigt oder kein FreeCAD-Dokument: {}: {}</translation>
    </message>
    <message>
        <source>is damaged: it has too many members, or one twice: {}</source>
        <translation>ist beschädigt: es hat zu viele Bestandteile oder einen doppelt: {}</translation>
    </message>
    <message>
        <source>is damaged: its reader crashes on it ({}): {}</source>
        <translation>ist beschädigt: das Leseprogramm stürzt daran ab ({}): {}</translation>
    </message>
    <message>
        <source>is exceeded in {}: {} % of the tetrahedra have an angle below {} degrees between their sides, beside elements that are thin: raise first_height there, or lower size</source>
        <translation>wird in {} überschritten: {} % der Tetraeder haben einen Winkel unter {} Grad zwischen ihren Seiten, neben dünnen Elementen: dort die erste Höhe vergrößern oder die Größe verkleinern</translation>
    </message>
    <message>
        <source>is for FCStd files only, got {}</source>
        <translation>nur bei FCStd-Dateien, angegeben ist {}</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>ist doppelt angegeben</translation>
    </message>
    <message>
        <source>is larger than any of the core: {}</source>
        <translation>ist größer als jede Datei des Kerns: {}</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>is neither cell, constraint nor property of {}</source>
        <translation>ist weder Zelle, Einschränkung noch Eigenschaft von {}</translation>
    </message>
    <message>
        <source>is neither file nor folder: {}</source>
        <translation>ist weder Datei noch Ordner: {}</translation>
    </message>
    <message>
        <source>is no FreeCAD document: it lacks {}: {}</source>
        <translation>ist kein FreeCAD-Dokument: es fehlt {}: {}</translation>
    </message>
    <message>
        <source>is no file: {}</source>
        <translation>ist keine Datei: {}</translation>
    </message>
    <message>
        <source>is no known key</source>
        <translation>ist kein bekannter Schlüssel</translation>
    </message>
    <message>
        <source>is no known key (did you mean {}?)</source>
        <translation>ist kein bekannter Schlüssel (war {} gemeint?)</translation>
    </message>
    <message>
        <source>is no name like {}</source>
        <translation>ist kein Name wie {}</translation>
    </message>
    <message>
        <source>is no regular file: {}</source>
        <translation>ist keine gewöhnliche Datei: {}</translation>
    </message>
    <message>
        <source>is not installed: {}</source>
        <translation>ist nicht installiert: {}</translation>
    </message>
    <message>
        <source>is of surfaces: 9 does not go with extrude or volume</source>
        <translation>gilt für Flächen: 9 passt nicht zu Extrusion oder Volumen</translation>
    </message>
    <message>
        <source>is the name of the front, too: {}</source>
        <translation>heißt wie die Vorderseite: {}</translation>
    </message>
    <message>
        <source>it bounds no face</source>
        <translation>sie begrenzt keine Fläche</translation>
    </message>
    <message>
        <source>it bounds {} alone</source>
        <translation>sie begrenzt nur {}</translation>
    </message>
    <message>
        <source>it has no area</source>
        <translation>sie hat keinen Flächeninhalt</translation>
    </message>
    <message>
        <source>it has no boundary wire</source>
        <translation>sie hat keinen Rand</translation>
    </message>
    <message>
        <source>it has no element about {} on {}: it is a mesh of another shape, or not whole</source>
        <translation>es hat kein Element bei {} auf {}: Es ist das Netz einer anderen Form, oder unvollständig</translation>
    </message>
    <message>
        <source>it has no finite bounds</source>
        <translation>sie ist unbegrenzt</translation>
    </message>
    <message>
        <source>it has no surface</source>
        <translation>sie hat keine Trägerfläche</translation>
    </message>
    <message>
        <source>it has no surface elements</source>
        <translation>es hat keine Flächenelemente</translation>
    </message>
    <message>
        <source>it is a pole without length</source>
        <translation>sie ist ein Pol ohne Länge</translation>
    </message>
    <message>
        <source>it is cut off: it lacks the line {}</source>
        <translation>sie ist abgeschnitten: die Zeile {} fehlt</translation>
    </message>
    <message>
        <source>it is cut off: its last line is missing</source>
        <translation>sie ist abgeschnitten: die letzte Zeile fehlt</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) cannot be read: {}</source>
        <translation>sie ist beschädigt: #{} ({}) kann nicht gelesen werden: {}</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) is part of nothing</source>
        <translation>sie ist beschädigt: #{} ({}) gehört zu nichts</translation>
    </message>
    <message>
        <source>it is damaged: #{} ({}) refers to #{}, which is not there</source>
        <translation>sie ist beschädigt: #{} ({}) verweist auf #{}, das nicht da ist</translation>
    </message>
    <message>
        <source>it is damaged: #{} is given twice</source>
        <translation>sie ist beschädigt: #{} steht zweimal darin</translation>
    </message>
    <message>
        <source>it is damaged: an entry has lost a line</source>
        <translation>sie ist beschädigt: einem Eintrag fehlt eine Zeile</translation>
    </message>
    <message>
        <source>it is damaged: it holds no entity</source>
        <translation>sie ist beschädigt: sie enthält nichts</translation>
    </message>
    <message>
        <source>it is damaged: line {}: {}</source>
        <translation>sie ist beschädigt: Zeile {}: {}</translation>
    </message>
    <message>
        <source>it is damaged: line {}: {} is missing</source>
        <translation>sie ist beschädigt: Zeile {}: {} fehlt</translation>
    </message>
    <message>
        <source>it is damaged: of the lines {} it has {}, its last line says {}</source>
        <translation>sie ist beschädigt: von den Zeilen {} hat sie {}, ihre letzte Zeile nennt {}</translation>
    </message>
    <message>
        <source>it is damaged: the entry D{} has no parameters of its type {}</source>
        <translation>sie ist beschädigt: der Eintrag D{} hat keine Parameter seines Typs {}</translation>
    </message>
    <message>
        <source>it is damaged: the entry D{} has no type</source>
        <translation>sie ist beschädigt: der Eintrag D{} hat keinen Typ</translation>
    </message>
    <message>
        <source>it is damaged: the face #{} or a bound of it could not be made</source>
        <translation>sie ist beschädigt: die Fläche #{} oder ein Rand von ihr ließ sich nicht bilden</translation>
    </message>
    <message>
        <source>it is damaged: the face D{} or a bound of it could not be made</source>
        <translation>sie ist beschädigt: die Fläche D{} oder ein Rand von ihr ließ sich nicht bilden</translation>
    </message>
    <message>
        <source>it is damaged: triangle {} has a corner that is nowhere</source>
        <translation>sie ist beschädigt: das Dreieck {} hat eine Ecke, die nirgends liegt</translation>
    </message>
    <message>
        <source>it is damaged: {} has no end</source>
        <translation>sie ist beschädigt: {} hat kein Ende</translation>
    </message>
    <message>
        <source>it is damaged: {} lies {} mm off {}</source>
        <translation>sie ist beschädigt: {} liegt {} mm neben {}</translation>
    </message>
    <message>
        <source>it is damaged: {} triangles take {} bytes, it has {}</source>
        <translation>sie ist beschädigt: {} Dreiecke brauchen {} Bytes, sie hat {}</translation>
    </message>
    <message>
        <source>it is no IGES file: its first line is missing</source>
        <translation>sie ist keine IGES-Datei: die erste Zeile fehlt</translation>
    </message>
    <message>
        <source>it is no STEP file: it lacks the line {}</source>
        <translation>sie ist keine STEP-Datei: die Zeile {} fehlt</translation>
    </message>
    <message>
        <source>it is no STL file</source>
        <translation>sie ist keine STL-Datei</translation>
    </message>
    <message>
        <source>it is not allowed to write there</source>
        <translation>dort darf nicht geschrieben werden</translation>
    </message>
    <message>
        <source>its boundary is open after {}</source>
        <translation>ihr Rand ist offen nach {}</translation>
    </message>
    <message>
        <source>its boundary runs around the closed surface without a seam, at {}</source>
        <translation>ihr Rand läuft ohne Naht um die geschlossene Fläche herum, bei {}</translation>
    </message>
    <message>
        <source>its faces meet at {} degrees, and {} is the most that layers run over</source>
        <translation>ihre Flächen treffen sich unter {} Grad; Schichten laufen höchstens über {} Grad hinweg</translation>
    </message>
    <message>
        <source>its faces use it more than twice</source>
        <translation>ihre Flächen benutzen sie mehr als zweimal</translation>
    </message>
    <message>
        <source>its whole boundary is shorter than its tolerance</source>
        <translation>Ihr ganzer Rand ist kürzer als seine Toleranz</translation>
    </message>
    <message>
        <source>joined with its neighbour</source>
        <translation>mit dem Nachbarn verschmolzen</translation>
    </message>
    <message>
        <source>layers 0 grows until the fronts close, which leaves no choice of thickness</source>
        <translation>0 Schichten heißt: bis die Fronten sich schließen; das lässt keine Wahl der Dicke</translation>
    </message>
    <message>
        <source>lies in a folder that cannot be written to: {}</source>
        <translation>in diesen Ordner lässt sich nichts schreiben: {}</translation>
    </message>
    <message>
        <source>lies in a folder that does not exist: {}</source>
        <translation>diesen Ordner gibt es nicht: {}</translation>
    </message>
    <message>
        <source>match</source>
        <translation>Anschluss</translation>
    </message>
    <message>
        <source>meshed on their own, as the elements of their patches could not follow them: {}</source>
        <translation>Für sich vernetzt, weil die Elemente ihrer Teilflächen ihnen nicht folgen konnten: {}</translation>
    </message>
    <message>
        <source>meshed on their own, as their patches could not be meshed with them: {}</source>
        <translation>Für sich vernetzt, weil ihre Gebiete mit ihnen nicht vernetzt werden konnten: {}</translation>
    </message>
    <message>
        <source>meshed on their own, as they are curved more tightly than layers of this size can follow: {}</source>
        <translation>Für sich vernetzt, weil sie enger gekrümmt sind, als Schichten dieser Größe folgen können: {}</translation>
    </message>
    <message>
        <source>must be "all" or a list of walls, got {}</source>
        <translation>verlangt ist "all" oder eine Liste von Wänden, angegeben {}</translation>
    </message>
    <message>
        <source>must be "split" at order 2, got "keep"</source>
        <translation>muss bei Ordnung 2 "split" sein, nicht "keep"</translation>
    </message>
    <message>
        <source>must be a file of its own that ends in {}, got {}</source>
        <translation>muss eine eigene Datei sein, die auf {} endet, ist aber {}</translation>
    </message>
    <message>
        <source>must be a finite number, got {}</source>
        <translation>verlangt ist eine endliche Zahl, angegeben {}</translation>
    </message>
    <message>
        <source>must be a list of files, got {}</source>
        <translation>verlangt ist eine Liste von Dateien, angegeben {}</translation>
    </message>
    <message>
        <source>must be a list of names like {}, got {}</source>
        <translation>verlangt ist eine Liste von Namen wie {}, angegeben {}</translation>
    </message>
    <message>
        <source>must be a list, got {}</source>
        <translation>verlangt ist eine Liste, angegeben {}</translation>
    </message>
    <message>
        <source>must be a mesh object, got {}</source>
        <translation>verlangt ist ein Netzobjekt, angegeben {}</translation>
    </message>
    <message>
        <source>must be a number or a text, got {}</source>
        <translation>muss eine Zahl oder ein Text sein, ist aber {}</translation>
    </message>
    <message>
        <source>must be a number {}, got {}</source>
        <translation>verlangt ist eine Zahl {}, angegeben {}</translation>
    </message>
    <message>
        <source>must be a number, got {}</source>
        <translation>verlangt ist eine Zahl, angegeben {}</translation>
    </message>
    <message>
        <source>must be a text, got {}</source>
        <translation>verlangt ist ein Text, angegeben {}</translation>
    </message>
    <message>
        <source>must be a whole number or "isotropic", got {}</source>
        <translation>verlangt ist eine ganze Zahl oder "isotropic", angegeben {}</translation>
    </message>
    <message>
        <source>must be a whole number, got {}</source>
        <translation>verlangt ist eine ganze Zahl, angegeben {}</translation>
    </message>
    <message>
        <source>must be an object of names and lists, got {}</source>
        <translation>verlangt ist ein Objekt aus Namen und Listen, angegeben {}</translation>
    </message>
    <message>
        <source>must be an object of names and values, got {}</source>
        <translation>muss ein Objekt aus Namen und Werten sein, ist aber {}</translation>
    </message>
    <message>
        <source>must be an object of names and words, got {}</source>
        <translation>muss ein Objekt aus Namen und Wörtern sein, ist {}</translation>
    </message>
    <message>
        <source>must be an object, got {}</source>
        <translation>verlangt ist ein Objekt, angegeben {}</translation>
    </message>
    <message>
        <source>must be at most 1000000, got {}</source>
        <translation>höchstens 1000000, angegeben {}</translation>
    </message>
    <message>
        <source>must be at right angles to the plane, whose normal is ({}, {}, {})</source>
        <translation>muss senkrecht auf der Ebene stehen, deren Normale ({}, {}, {}) ist</translation>
    </message>
    <message>
        <source>must be in the same document as the shape, got {}</source>
        <translation>muss im selben Dokument liegen wie die Form, angegeben {}</translation>
    </message>
    <message>
        <source>must be one of {}, got {}</source>
        <translation>verlangt ist eines von {}, angegeben {}</translation>
    </message>
    <message>
        <source>must be three numbers, got {}</source>
        <translation>verlangt sind drei Zahlen, angegeben {}</translation>
    </message>
    <message>
        <source>must be true or false, got {}</source>
        <translation>verlangt ist wahr oder falsch, angegeben {}</translation>
    </message>
    <message>
        <source>must be {}, got {}</source>
        <translation>verlangt ist {}, angegeben {}</translation>
    </message>
    <message>
        <source>must have a length</source>
        <translation>muss eine Länge haben</translation>
    </message>
    <message>
        <source>must hold texts like "Face1 move x y z", got {}</source>
        <translation>muss Texte wie „Face1 move x y z“ enthalten, nicht {}</translation>
    </message>
    <message>
        <source>must hold texts like "x y z size radius", got {}</source>
        <translation>verlangt sind Texte wie "x y z Größe Radius", angegeben {}</translation>
    </message>
    <message>
        <source>must lie in the plane of the mesh</source>
        <translation>muss in der Ebene des Netzes liegen</translation>
    </message>
    <message>
        <source>must not be empty</source>
        <translation>ohne Angabe geht es nicht</translation>
    </message>
    <message>
        <source>names all of {}: pick its faces or edges</source>
        <translation>{} ist als Ganzes genannt: Wählen Sie Flächen oder Kanten davon</translation>
    </message>
    <message>
        <source>names no file, and there is no report: nothing to do</source>
        <translation>keine Datei genannt, und kein Bericht: nichts zu tun</translation>
    </message>
    <message>
        <source>names no object of the document, or several</source>
        <translation>nennt kein Objekt des Dokuments oder mehrere</translation>
    </message>
    <message>
        <source>names {} of {}, which is no part of {}</source>
        <translation>{} von {} ist genannt, das kein Teil von {} ist</translation>
    </message>
    <message>
        <source>names {} twice</source>
        <translation>{} ist doppelt genannt</translation>
    </message>
    <message>
        <source>names {}, but the shape has {} of that kind</source>
        <translation>{} ist genannt, aber die Form hat {} davon</translation>
    </message>
    <message>
        <source>names {}, but {} has {} edges</source>
        <translation>{} ist genannt, aber die Kanten von {} sind nur {}</translation>
    </message>
    <message>
        <source>names {}, but {} has {} faces</source>
        <translation>{} ist genannt, aber die Flächen von {} sind nur {}</translation>
    </message>
    <message>
        <source>names {}, which is not in faces</source>
        <translation>{} ist genannt, aber nicht unter den zu vernetzenden Flächen</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {}</source>
        <translation>Schmaler als ein Zehntel der Größe, und ihre Elemente mit ihnen: {}</translation>
    </message>
    <message>
        <source>narrower than a tenth of the size, and their elements with them: {} and {} more</source>
        <translation>Schmaler als ein Zehntel der Größe, und ihre Elemente mit ihnen: {} und {} weitere</translation>
    </message>
    <message>
        <source>needs FreeCAD to be read: run the job with freecadcmd: {}</source>
        <translation>braucht zum Lesen FreeCAD: Führen Sie den Auftrag mit freecadcmd aus: {}</translation>
    </message>
    <message>
        <source>needs FreeCAD to be written: run the job with freecadcmd: {}</source>
        <translation>braucht zum Schreiben FreeCAD: Führen Sie den Auftrag mit freecadcmd aus: {}</translation>
    </message>
    <message>
        <source>needs a mesh of plane faces: there is no element</source>
        <translation>braucht ein Netz ebener Flächen: kein Element vorhanden</translation>
    </message>
    <message>
        <source>needs both density and viscosity, or none of them</source>
        <translation>braucht Dichte und Viskosität oder keine von beiden</translation>
    </message>
    <message>
        <source>needs plane faces: a node lies {} mm off their plane</source>
        <translation>braucht ebene Flächen: ein Knoten liegt {} mm neben ihrer Ebene</translation>
    </message>
    <message>
        <source>needs the Python package meshio (python3-meshio): {}</source>
        <translation>braucht das Python-Paket meshio (python3-meshio): {}</translation>
    </message>
    <message>
        <source>needs the Python package {} (python3-{}): {}</source>
        <translation>braucht das Python-Paket {} (python3-{}): {}</translation>
    </message>
    <message>
        <source>no growth from 1 to {} makes {} layers from {} mm {} mm thick</source>
        <translation>kein Wachstumsfaktor von 1 bis {} macht {} Schichten ab {} mm zusammen {} mm dick</translation>
    </message>
    <message>
        <source>no shape could be read, it is no {} file or holds none</source>
        <translation>keine Form war zu lesen, es ist keine {}-Datei oder sie enthält keine</translation>
    </message>
    <message>
        <source>no tetrahedron came out, exit status {}</source>
        <translation>es kam kein Tetraeder heraus, Rückgabewert {}</translation>
    </message>
    <message>
        <source>no valid element fits</source>
        <translation>kein gültiges Element passt</translation>
    </message>
    <message>
        <source>node {} (from 0) at {} lies {} mm off the shape; the most is {} mm, a quarter of the mesh's edge length there</source>
        <translation>Knoten {} (von 0 gezählt) bei {} liegt {} mm neben der Form; erlaubt sind {} mm, ein Viertel der dortigen Kantenlänge des Netzes</translation>
    </message>
    <message>
        <source>node {} (from 0) has the coordinates {}</source>
        <translation>Knoten {} (von 0 gezählt) hat die Koordinaten {}</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keines</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>nothing arrived there: the disk may be full</source>
        <translation>dort ist nichts angekommen: vielleicht ist der Datenträger voll</translation>
    </message>
    <message>
        <source>of a new {} must not be empty</source>
        <translation>für das neue Objekt ({}) ist nichts gewählt</translation>
    </message>
    <message>
        <source>of a {} cannot hold {}</source>
        <translation>für ein solches Objekt ({}) nicht möglich: {}</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>pick a face or an edge of {}</source>
        <translation>wählen Sie eine Fläche oder Kante von {}</translation>
    </message>
    <message>
        <source>pick a face, an edge or a vertex of {}</source>
        <translation>wählen Sie eine Fläche, eine Kante oder einen Eckpunkt von {}</translation>
    </message>
    <message>
        <source>pipe</source>
        <translation>Rohr</translation>
    </message>
    <message>
        <source>plate</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>point {} of a triangulation is not finite</source>
        <translation>Punkt {} einer Triangulierung ist nicht endlich</translation>
    </message>
    <message>
        <source>polyMesh: three cells share a face</source>
        <translation>polyMesh: drei Zellen teilen sich eine Seite</translation>
    </message>
    <message>
        <source>quads</source>
        <translation>Vierecke</translation>
    </message>
    <message>
        <source>result() was called already; keep what it gave</source>
        <translation>result() wurde schon aufgerufen; behalten Sie, was es ergab</translation>
    </message>
    <message>
        <source>segments and cluster are of edges, and the entry lists none</source>
        <translation>Abschnitte und Verdichtung gelten für Kanten, und es ist keine gewählt</translation>
    </message>
    <message>
        <source>select faces or edges in the 3D view first</source>
        <translation>wählen Sie zuerst Flächen oder Kanten in der 3D-Ansicht</translation>
    </message>
    <message>
        <source>select in the 3D view first: {}</source>
        <translation>wählen Sie zuerst in der 3D-Ansicht: {}</translation>
    </message>
    <message>
        <source>select {} first</source>
        <translation>wählen Sie zuerst {}</translation>
    </message>
    <message>
        <source>sewing joined {} edges; free edges left: {}</source>
        <translation>Beim Nähen wurden {} Kanten verbunden; freie Kanten übrig: {}</translation>
    </message>
    <message>
        <source>sewing left nothing of the shape</source>
        <translation>das Nähen hat von der Form nichts übrig gelassen</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {}</source>
        <translation>Kürzer als ein Zehntel der Größe, und die Netzkanten mit ihnen: {}</translation>
    </message>
    <message>
        <source>shorter than a tenth of the size, and the mesh edges with them: {} and {} more</source>
        <translation>Kürzer als ein Zehntel der Größe, und die Netzkanten mit ihnen: {} und {} weitere</translation>
    </message>
    <message>
        <source>shorter than the tolerance about them, and one point in the mesh: {}</source>
        <translation>Kürzer als die Toleranz um sie, und im Netz ein Punkt: {}</translation>
    </message>
    <message>
        <source>shorter than the tolerance about them, and one point in the mesh: {} and {} more</source>
        <translation>Kürzer als die Toleranz um sie, und im Netz ein Punkt: {} und {} weitere</translation>
    </message>
    <message>
        <source>size and segments of an edge exclude each other</source>
        <translation>Elementgröße und Zahl der Abschnitte einer Kante schließen einander aus</translation>
    </message>
    <message>
        <source>tanh</source>
        <translation>tanh</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>the folder does not exist</source>
        <translation>den Ordner gibt es nicht</translation>
    </message>
    <message>
        <source>the fronts have met</source>
        <translation>die Fronten sind zusammengetroffen</translation>
    </message>
    <message>
        <source>the job file is nested too deeply</source>
        <translation>die Auftragsdatei ist zu tief geschachtelt</translation>
    </message>
    <message>
        <source>the job file is no JSON: {} in line {}</source>
        <translation>die Auftragsdatei ist kein JSON: {} in Zeile {}</translation>
    </message>
    <message>
        <source>the job file is not UTF-8 text</source>
        <translation>die Auftragsdatei ist kein UTF-8-Text</translation>
    </message>
    <message>
        <source>the job file must hold one JSON object</source>
        <translation>die Auftragsdatei muss ein JSON-Objekt enthalten</translation>
    </message>
    <message>
        <source>the layers beside have ended</source>
        <translation>die Schichten daneben haben geendet</translation>
    </message>
    <message>
        <source>the mesh will have some {} elements</source>
        <translation>das Netz wird etwa {} Elemente haben</translation>
    </message>
    <message>
        <source>the meshing core is not built for this FreeCAD (Python {}): run "./dev build" in {} and start FreeCAD again ({})</source>
        <translation>Der Netzkern ist für dieses FreeCAD (Python {}) nicht gebaut: Rufen Sie "./dev build" in {} auf und starten Sie FreeCAD neu ({})</translation>
    </message>
    <message>
        <source>the meshing core is of version {}, but this add-on needs {}: install the core of the same version ({})</source>
        <translation>der Vernetzungskern hat die Version {}, diese Erweiterung braucht aber {}: bitte den Kern derselben Version einrichten ({})</translation>
    </message>
    <message>
        <source>the model has changed under the references: {}. Pick them again, or use Follow References or Accept References</source>
        <translation>Das Modell hat sich unter den Referenzen geändert: {}. Wählen Sie neu, oder nutzen Sie „Referenzen nachführen“ oder „Referenzen annehmen“</translation>
    </message>
    <message>
        <source>the shape holds no face</source>
        <translation>die Form hat keine Fläche</translation>
    </message>
    <message>
        <source>the surface bends too sharply</source>
        <translation>die Fläche biegt sich zu stark</translation>
    </message>
    <message>
        <source>the text is no BREP shape</source>
        <translation>der Text ist keine BREP-Form</translation>
    </message>
    <message>
        <source>the text is no BREP shape: it lacks the line {}</source>
        <translation>der Text ist keine BREP-Form: Ihm fehlt die Zeile {}</translation>
    </message>
    <message>
        <source>the text is no BREP shape: line {}: {}</source>
        <translation>der Text ist keine BREP-Form: Zeile {}: {}</translation>
    </message>
    <message>
        <source>the triangulation took {} of the {} nodes of the initial mesh; the others lie on edges or too near to their neighbours</source>
        <translation>Die Triangulierung hat {} der {} Knoten des Ausgangsnetzes übernommen; die anderen liegen auf Kanten oder zu nah an ihren Nachbarn</translation>
    </message>
    <message>
        <source>there is no snapshot after result(): it gave the mesh</source>
        <translation>nach result() gibt es keinen Zwischenstand mehr: es hat das Netz ergeben</translation>
    </message>
    <message>
        <source>thickness needs a first height that is the same along the wall</source>
        <translation>die Dicke braucht eine erste Höhe, die entlang der Wand gleich bleibt</translation>
    </message>
    <message>
        <source>thickness would take {} layers</source>
        <translation>für die Dicke wären {} Schichten nötig</translation>
    </message>
    <message>
        <source>thickness {} mm is less than the first height {} mm</source>
        <translation>die Dicke {} mm ist geringer als die erste Höhe {} mm</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>triangle {} (from 0) has node {}, but there are {}</source>
        <translation>Dreieck {} (von 0 gezählt) hat den Knoten {}, es gibt aber nur {}</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>washers</source>
        <translation>Scheiben</translation>
    </message>
    <message>
        <source>water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>without a unit</source>
        <translation>ohne Einheit</translation>
    </message>
    <message>
        <source>would overwrite {}: {}</source>
        <translation>würde dies überschreiben: {}: {}</translation>
    </message>
    <message>
        <source>{edge} on {face} has no layer</source>
        <translation>{edge} auf {face} hat keine Schicht</translation>
    </message>
    <message>
        <source>{edge} on {face}: layers end here first: {reason}</source>
        <translation>{edge} auf {face}: hier enden Schichten zuerst: {reason}</translation>
    </message>
    <message>
        <source>{edge} on {face}: the first height is most off here, by {error:+.1f} %</source>
        <translation>{edge} auf {face}: die erste Höhe weicht hier am meisten ab, um {error:+.1f} %</translation>
    </message>
    <message>
        <source>{label}: layer {layer}, {elements} elements, {seconds} s</source>
        <translation>{label}: Schicht {layer}, {elements} Elemente, {seconds} s</translation>
    </message>
    <message>
        <source>{label}: {quads} quads, {triangles} triangles, {percent:.1f} % quads, {good:.1f} % of angles in 45–135°, angles from {least:.1f}° to {largest:.1f}°</source>
        <translation>{label}: {quads} Vierecke, {triangles} Dreiecke, {percent:.1f} % Vierecke, {good:.1f} % der Winkel in 45–135°, Winkel von {least:.1f}° bis {largest:.1f}°</translation>
    </message>
    <message>
        <source>{label}: {seconds} s</source>
        <translation>{label}: {seconds} s</translation>
    </message>
    <message>
        <source>{quads} quads and {triangles} triangles ({percent:.1f} % quads) in {seconds:.1f} s</source>
        <translation>{quads} Vierecke und {triangles} Dreiecke ({percent:.1f} % Vierecke) in {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{stage} · {elements} elements · {percent:.1f} % quads · {seconds:.1f} s</source>
        <translation>{stage} · {elements} Elemente · {percent:.1f} % Vierecke · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{stage} · {seconds:.1f} s</source>
        <translation>{stage} · {seconds:.1f} s</translation>
    </message>
    <message>
        <source>{} (internal error: please report it with the model)</source>
        <translation>{} (interner Fehler: bitte mit dem Modell melden)</translation>
    </message>
    <message>
        <source>{} and {}</source>
        <translation>{} und {}</translation>
    </message>
    <message>
        <source>{} and {} exclude each other</source>
        <translation>{} und {} schließen sich aus</translation>
    </message>
    <message>
        <source>{} and {} more: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{} und {} weitere: erste Höhen von {} bis {} mm; verlangt waren im Mittel {} mm, Abweichung bis zu {} %</translation>
    </message>
    <message>
        <source>{} belongs to no layer mesh of a shape</source>
        <translation>{} gehört zu keinem Schichtnetz einer Form</translation>
    </message>
    <message>
        <source>{} bounds no meshed patch, and no layers grow from it; listed in boundary, it bounds its faces</source>
        <translation>{} begrenzt keine vernetzte Teilfläche, und es wachsen keine Schichten daraus; als Rand angegeben, begrenzt sie ihre Flächen</translation>
    </message>
    <message>
        <source>{} came after the mesh and does not act on it: update the mesh.</source>
        <translation>{} kam nach dem Netz und wirkt nicht darauf: Aktualisieren Sie das Netz.</translation>
    </message>
    <message>
        <source>{} cannot be filled: {} of {} cells have no volume, or a negative one</source>
        <translation>{} lässt sich nicht füllen: {} von {} Zellen haben kein Volumen oder ein negatives</translation>
    </message>
    <message>
        <source>{} cannot be meshed: {}</source>
        <translation>{} lässt sich nicht vernetzen: {}</translation>
    </message>
    <message>
        <source>{} cannot be written: {}</source>
        <translation>{} lässt sich nicht schreiben: {}</translation>
    </message>
    <message>
        <source>{} does not close to a manifold mesh</source>
        <translation>{} schließt sich nicht zu einem mannigfaltigen Netz</translation>
    </message>
    <message>
        <source>{} elements are turned over.</source>
        <translation>{} Elemente sind invertiert.</translation>
    </message>
    <message>
        <source>{} elements of quality {:.2f} to {:.2f}</source>
        <translation>{} Elemente mit Qualität {:.2f} bis {:.2f}</translation>
    </message>
    <message>
        <source>{} faces meet there</source>
        <translation>dort treffen sich {} Flächen</translation>
    </message>
    <message>
        <source>{} files have no edges: the group {} of {} would be lost in {}</source>
        <translation>Dateien für {} haben keine Kanten: Die Gruppe {} mit {} ginge verloren in {}</translation>
    </message>
    <message>
        <source>{} files have no elements of second order: {}</source>
        <translation>Dateien für {} haben keine Elemente zweiter Ordnung: {}</translation>
    </message>
    <message>
        <source>{} files have no pyramids, which stand on quads that are kept: {}</source>
        <translation>{}-Dateien haben keine Pyramiden, die auf behaltenen Vierecken stehen: {}</translation>
    </message>
    <message>
        <source>{} files have no pyramids, which the mesh has along the axis: {}</source>
        <translation>{}-Dateien haben keine Pyramiden, die das Netz längs der Achse hat: {}</translation>
    </message>
    <message>
        <source>{} files have no quads of {} nodes: {}</source>
        <translation>{}-Dateien haben keine Vierecke mit {} Knoten: {}</translation>
    </message>
    <message>
        <source>{} files have no volume elements: {}</source>
        <translation>Dateien für {} haben keine Volumenelemente: {}</translation>
    </message>
    <message>
        <source>{} files have one name for each element: {} is in the groups {} and {}, which {} cannot hold</source>
        <translation>Dateien für {} haben einen Namen je Element: {} ist in den Gruppen {} und {}, die {} nicht beide fassen kann</translation>
    </message>
    <message>
        <source>{} has a slit there</source>
        <translation>{} hat dort einen Schlitz</translation>
    </message>
    <message>
        <source>{} has no (u, v) on {}</source>
        <translation>{} hat kein (u, v) auf {}</translation>
    </message>
    <message>
        <source>{} has no boundary edge that layers could grow from</source>
        <translation>{} hat keine Randkante, aus der Schichten wachsen könnten</translation>
    </message>
    <message>
        <source>{} has no curve</source>
        <translation>{} hat keine Kurve</translation>
    </message>
    <message>
        <source>{} has no curve in the face's (u, v)</source>
        <translation>{} hat keine Kurve im (u, v) der Fläche</translation>
    </message>
    <message>
        <source>{} has no face to mesh</source>
        <translation>{} hat keine Fläche zum Vernetzen</translation>
    </message>
    <message>
        <source>{} has no face to mesh: {}</source>
        <translation>{} hat keine Fläche zum Vernetzen: {}</translation>
    </message>
    <message>
        <source>{} has no mesh yet: mesh it first</source>
        <translation>{} hat noch kein Netz: Vernetzen Sie zuerst</translation>
    </message>
    <message>
        <source>{} has no object to mesh</source>
        <translation>{} hat kein Objekt zum Vernetzen</translation>
    </message>
    <message>
        <source>{} has no surface elements: mesh it first</source>
        <translation>{} hat keine Flächenelemente: Vernetzen Sie es zuerst</translation>
    </message>
    <message>
        <source>{} has no value for its size: give one for the surroundings of {}</source>
        <translation>{} hat keinen Wert für die Elementgröße: Geben Sie einen an für die Umgebung von {}</translation>
    </message>
    <message>
        <source>{} has none of these</source>
        <translation>{} hat nichts davon</translation>
    </message>
    <message>
        <source>{} has the sizes of {}, {} walls, {} local sizes and {} groups.</source>
        <translation>{} hat die Größen von {}, {} Wände, {} örtliche Größen und {} Gruppen.</translation>
    </message>
    <message>
        <source>{} has {} cells inside {}.</source>
        <translation>{} hat {} Zellen in {}.</translation>
    </message>
    <message>
        <source>{} is called {} now</source>
        <translation>{} heißt jetzt {}</translation>
    </message>
    <message>
        <source>{} is damaged: {}</source>
        <translation>{} ist beschädigt: {}</translation>
    </message>
    <message>
        <source>{} is damaged: {} is not as its list says</source>
        <translation>{} ist beschädigt: {} ist nicht, wie die eigene Liste sagt</translation>
    </message>
    <message>
        <source>{} is gone from the model</source>
        <translation>{} ist aus dem Modell verschwunden</translation>
    </message>
    <message>
        <source>{} is in both {} and {}</source>
        <translation>{} steht sowohl unter {} als auch unter {}</translation>
    </message>
    <message>
        <source>{} is in error, and its shape may be an older one: mend it first</source>
        <translation>{} ist fehlerhaft, und die Form ist vielleicht eine ältere: erst beheben</translation>
    </message>
    <message>
        <source>{} is in error: the mesh cannot be updated before it is mended.</source>
        <translation>{} ist fehlerhaft: das Netz kann nicht aktualisiert werden, bevor das behoben ist.</translation>
    </message>
    <message>
        <source>{} is narrower than the tolerance of its edges: it holds no element, and its neighbours meet there</source>
        <translation>{} ist schmaler als die Toleranz ihrer Kanten: Sie trägt kein Element, und ihre Nachbarn treffen sich dort</translation>
    </message>
    <message>
        <source>{} is neither name nor label of an object: {}</source>
        <translation>{} ist weder Name noch Bezeichnung eines Objekts: {}</translation>
    </message>
    <message>
        <source>{} is no mesh made with Gmsh</source>
        <translation>{} ist kein mit Gmsh erzeugtes Netz</translation>
    </message>
    <message>
        <source>{} is no part of {}, which is meshed</source>
        <translation>{} ist kein Teil von {}, das vernetzt wird</translation>
    </message>
    <message>
        <source>{} is not among the faces to mesh</source>
        <translation>{} ist nicht unter den zu vernetzenden Flächen</translation>
    </message>
    <message>
        <source>{} is not closed: {} sides of elements have no neighbour, one at ({}, {}, {})</source>
        <translation>{} ist nicht geschlossen: {} Seiten von Elementen haben keinen Nachbarn, eine bei ({}, {}, {})</translation>
    </message>
    <message>
        <source>{} is not mapped: its outline has no four corners, and it is no ring in a plane</source>
        <translation>{} wird nicht abgebildet: ihr Umriss hat keine vier Ecken, und sie ist kein Ring in einer Ebene</translation>
    </message>
    <message>
        <source>{} is not mapped: its sides are cut into different numbers of segments, or rows between them would fold</source>
        <translation>{} wird nicht abgebildet: ihre Seiten sind in verschieden viele Abschnitte geteilt, oder Zeilen zwischen ihnen würden sich falten</translation>
    </message>
    <message>
        <source>{} is not meshed as {} is: they do not lie alike, or are parts of larger patches</source>
        <translation>{} wird nicht wie {} vernetzt: sie liegen nicht gleich oder sind Teile größerer Bereiche</translation>
    </message>
    <message>
        <source>{} is not meshed: {}</source>
        <translation>{} wird nicht vernetzt: {}</translation>
    </message>
    <message>
        <source>{} is not there any more</source>
        <translation>{} gibt es nicht mehr</translation>
    </message>
    <message>
        <source>{} is not what its sum says: {} instead of {}</source>
        <translation>{} ist nicht, was die Prüfsumme sagt: {} statt {}</translation>
    </message>
    <message>
        <source>{} is not what was picked</source>
        <translation>{} ist nicht das, was gewählt wurde</translation>
    </message>
    <message>
        <source>{} is on the list already</source>
        <translation>{} steht schon auf der Liste</translation>
    </message>
    <message>
        <source>{} is the label of several objects: {}</source>
        <translation>{} ist die Bezeichnung mehrerer Objekte: {}</translation>
    </message>
    <message>
        <source>{} is too small: it would cut {} into {} segments</source>
        <translation>{} zu klein: {} würde in {} Abschnitte geteilt</translation>
    </message>
    <message>
        <source>{} is too small: {} mm asks for {} elements, and {} are the most</source>
        <translation>{} zu klein: {} mm verlangen {} Elemente, höchstens {} sind möglich</translation>
    </message>
    <message>
        <source>{} joins no two sides of {}</source>
        <translation>{} verbindet keine zwei Seiten von {}</translation>
    </message>
    <message>
        <source>{} layers</source>
        <translation>{} Schichten</translation>
    </message>
    <message>
        <source>{} meets the wall {} at {} degrees on {}: layers end there instead of running along it</source>
        <translation>{} trifft die Wand {} unter {} Grad auf {}: Schichten enden dort, statt daran entlangzulaufen</translation>
    </message>
    <message>
        <source>{} mid nodes follow the curved edges beside them less than in proportion: curved elements would be turned over</source>
        <translation>{} Mittelknoten folgen den gekrümmten Kanten neben ihnen weniger als im Verhältnis: gekrümmte Elemente wären sonst umgestülpt</translation>
    </message>
    <message>
        <source>{} mid nodes lie off the shape, by up to {} mm: on it, curved elements would be turned over</source>
        <translation>{} Mittelknoten liegen neben der Form, um bis zu {} mm: auf ihr wären gekrümmte Elemente umgestülpt</translation>
    </message>
    <message>
        <source>{} mid nodes of the volume's skin lie off the shape, by up to {} mm: on it, cells would be turned over</source>
        <translation>{} Mittelknoten der Haut des Volumens liegen neben der Form, um bis zu {} mm: auf ihr wären Zellen umgestülpt</translation>
    </message>
    <message>
        <source>{} must be {}, got {}</source>
        <translation>{}: verlangt ist {}, angegeben {}</translation>
    </message>
    <message>
        <source>{} must be {}, got {} ({})</source>
        <translation>{}: verlangt ist {}, angegeben {} ({})</translation>
    </message>
    <message>
        <source>{} needs cells: ask for extrude or volume: {}</source>
        <translation>{} braucht Zellen: extrude oder volume verlangen: {}</translation>
    </message>
    <message>
        <source>{} nodes of the initial mesh lay off the shape, by up to {} mm, and were put onto it</source>
        <translation>{} Knoten des Ausgangsnetzes lagen bis zu {} mm neben der Form und wurden auf sie gesetzt</translation>
    </message>
    <message>
        <source>{} of {} tetrahedra have an angle below 5 degrees between two sides</source>
        <translation>{} von {} Tetraedern haben einen Winkel unter 5 Grad zwischen zwei Seiten</translation>
    </message>
    <message>
        <source>{} on {} got no layers</source>
        <translation>{} auf {} erhielt keine Schichten</translation>
    </message>
    <message>
        <source>{} on {} got {} complete layers of {}</source>
        <translation>{} auf {} erhielt {} vollständige Schichten von {}</translation>
    </message>
    <message>
        <source>{} refers to nothing: pick faces or edges for it</source>
        <translation>{} bezieht sich auf nichts: Wählen Sie Flächen oder Kanten dafür</translation>
    </message>
    <message>
        <source>{} shape</source>
        <translation>{} Form</translation>
    </message>
    <message>
        <source>{} times, the worst: {}</source>
        <translation>{}-mal, am schlimmsten: {}</translation>
    </message>
    <message>
        <source>{} volume</source>
        <translation>{} Volumen</translation>
    </message>
    <message>
        <source>{} was saved by a later version of Advancing Layers (schema {}, here {}): some of its settings may not be seen.</source>
        <translation>{} wurde von einer späteren Fassung von Advancing Layers gespeichert (Schema {}, hier {}): Einige Einstellungen sind vielleicht nicht zu sehen.</translation>
    </message>
    <message>
        <source>{} would cut {} into millions of segments</source>
        <translation>{} würde {} in Millionen Abschnitte teilen</translation>
    </message>
    <message>
        <source>{} {}</source>
        <translation>{}: {}</translation>
    </message>
    <message>
        <source>{}, {} and {} exclude each other</source>
        <translation>{}, {} und {} schließen einander aus</translation>
    </message>
    <message>
        <source>{}, {}, {} and {} are one too many: leave one out</source>
        <translation>{}, {}, {} und {} sind eine Angabe zu viel: Lassen Sie eine weg</translation>
    </message>
    <message>
        <source>{}: OpenCASCADE failed: {}{}</source>
        <translation>{}: OpenCASCADE ist gescheitert: {}{}</translation>
    </message>
    <message>
        <source>{}: an entry lists neither edge nor face</source>
        <translation>{}: ein Eintrag nennt weder Kante noch Fläche</translation>
    </message>
    <message>
        <source>{}: an entry lists no edge</source>
        <translation>{}: ein Eintrag nennt keine Kante</translation>
    </message>
    <message>
        <source>{}: an entry needs a translation or an angle</source>
        <translation>{}: ein Eintrag braucht eine Verschiebung oder einen Winkel</translation>
    </message>
    <message>
        <source>{}: coordinates must be finite</source>
        <translation>{}: Koordinaten müssen endlich sein</translation>
    </message>
    <message>
        <source>{}: first heights from {} to {} mm, off those asked for ({} mm on average) by up to {} %</source>
        <translation>{}: erste Höhen von {} bis {} mm; verlangt waren im Mittel {} mm, Abweichung bis zu {} %</translation>
    </message>
    <message>
        <source>{}: its boundary does not enclose a region</source>
        <translation>{}: Ihr Rand umschließt kein Gebiet</translation>
    </message>
    <message>
        <source>{}: its elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{}: Ihre Elemente reichen über Kanten im Inneren der Teilfläche; ein kleinerer Kantenwinkel trennt die Flächen</translation>
    </message>
    <message>
        <source>{}: its layers broke the mesh, and it is meshed without them: {}</source>
        <translation>{}: Ihre Schichten haben das Netz zerstört, und sie ist ohne sie vernetzt: {}</translation>
    </message>
    <message>
        <source>{}: its layers broke the mesh: {}</source>
        <translation>{}: Die Schichten haben das Netz zerstört: {}</translation>
    </message>
    <message>
        <source>{}: its segments are fixed: layers run along it where they fit</source>
        <translation>{}: Ihre Teilung steht fest: Schichten laufen daran entlang, wo sie passen</translation>
    </message>
    <message>
        <source>{}: its sides are one line</source>
        <translation>{}: Ihre Seiten sind eine Linie</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} and {} join the same two nodes; they are too long</source>
        <translation>{}: Netzkanten von {} und {} verbinden dieselben zwei Knoten; sie sind zu lang</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} cross or touch each other</source>
        <translation>{}: Netzkanten von {} schneiden oder berühren sich</translation>
    </message>
    <message>
        <source>{}: mesh edges of {} leave boundary on the wrong side</source>
        <translation>{}: Netzkanten von {} lassen den Rand auf der falschen Seite</translation>
    </message>
    <message>
        <source>{}: no edge lies where {} comes to lie</source>
        <translation>{}: wo {} zu liegen kommt, liegt keine Kante</translation>
    </message>
    <message>
        <source>{}: no face lies where {} comes to lie</source>
        <translation>{}: wo {} zu liegen kommt, liegt keine Fläche</translation>
    </message>
    <message>
        <source>{}: no process can be started to read it: {}</source>
        <translation>{}: kein Prozess kann gestartet werden, um sie zu lesen: {}</translation>
    </message>
    <message>
        <source>{}: point must be finite</source>
        <translation>{}: der Punkt muss endlich sein</translation>
    </message>
    <message>
        <source>{}: reading the {} file does not end within {} s</source>
        <translation>{}: das Lesen der {}-Datei endet nicht innerhalb von {} s</translation>
    </message>
    <message>
        <source>{}: reading the {} file takes more than {} MB</source>
        <translation>{}: das Lesen der {}-Datei braucht mehr als {} MB</translation>
    </message>
    <message>
        <source>{}: the ending is none of {}</source>
        <translation>{}: die Endung ist keine von {}</translation>
    </message>
    <message>
        <source>{}: the file cannot be opened</source>
        <translation>{}: die Datei lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>{}: the layers of the faces beside it would cut it differently; its nodes follow the mean, and leave the heights asked for by up to {} %</source>
        <translation>{}: Die Schichten der Flächen daneben würden sie verschieden teilen; ihre Knoten folgen dem Mittel und weichen um bis zu {} % von den verlangten Höhen ab</translation>
    </message>
    <message>
        <source>{}: the mesh of this step is not kept any more: update it.</source>
        <translation>{}: Das Netz dieses Schritts ist nicht mehr aufbewahrt: aktualisieren Sie es.</translation>
    </message>
    <message>
        <source>{}: the panel was closed from outside; its finished mesh was kept.</source>
        <translation>{}: das Fenster wurde von außen geschlossen; sein fertiges Netz wurde behalten.</translation>
    </message>
    <message>
        <source>{}: the {} file is damaged: its reader crashes on it ({})</source>
        <translation>{}: die {}-Datei ist beschädigt: das Leseprogramm stürzt daran ab ({})</translation>
    </message>
    <message>
        <source>{}: there is no {}, edges of the model: {}</source>
        <translation>{}: {} gibt es nicht, Kanten des Modells: {}</translation>
    </message>
    <message>
        <source>{}: there is no {}, faces of the model: {}</source>
        <translation>{}: {} gibt es nicht, Flächen des Modells: {}</translation>
    </message>
    <message>
        <source>{}: triangles more than 30 degrees off the surface: {}; the worst leans by {} degrees</source>
        <translation>{}: Dreiecke mehr als 30 Grad neben der Fläche: {}; das schlimmste neigt sich um {} Grad</translation>
    </message>
    <message>
        <source>{}: triangles turned over against the surface: {}; the worst leans by {} degrees</source>
        <translation>{}: gegen die Fläche invertierte Dreiecke: {}; das schlimmste neigt sich um {} Grad</translation>
    </message>
    <message>
        <source>{}: {} and {} exclude each other</source>
        <translation>{}: {} und {} schließen sich aus</translation>
    </message>
    <message>
        <source>{}: {} elements are turned over against the surface</source>
        <translation>{}: {} Elemente sind gegen die Fläche invertiert</translation>
    </message>
    <message>
        <source>{}: {} elements have an angle below 0.1 degrees</source>
        <translation>{}: {} Elemente haben einen Winkel unter 0,1 Grad</translation>
    </message>
    <message>
        <source>{}: {} elements have no area</source>
        <translation>{}: {} Elemente haben keine Fläche</translation>
    </message>
    <message>
        <source>{}: {} elements of layers were changed, as elements there were turned over</source>
        <translation>{}: {} Elemente von Schichten wurden geändert, weil dort Elemente invertiert waren</translation>
    </message>
    <message>
        <source>{}: {} elements reach over edges inside the patch; lower feature_angle to part its faces</source>
        <translation>{}: {} Elemente reichen über Kanten im Inneren der Teilfläche; ein kleinerer Kantenwinkel trennt die Flächen</translation>
    </message>
    <message>
        <source>{}: {} is a pole without length</source>
        <translation>{}: {} ist ein Pol ohne Länge</translation>
    </message>
    <message>
        <source>{}: {} is a pole without length, nothing grows there</source>
        <translation>{}: {} ist ein Pol ohne Länge, dort wächst nichts</translation>
    </message>
    <message>
        <source>{}: {} is listed twice</source>
        <translation>{}: {} ist doppelt genannt</translation>
    </message>
    <message>
        <source>{}: {} must bound its patch: {}</source>
        <translation>{}: {} muss ihre Teilfläche begrenzen: {}</translation>
    </message>
    <message>
        <source>{}: {} must not be zero</source>
        <translation>{}: {} darf nicht null sein</translation>
    </message>
    <message>
        <source>{}: {} needs an edge with two ends, {} is closed</source>
        <translation>{}: {} braucht eine Kante mit zwei Enden, {} ist geschlossen</translation>
    </message>
    <message>
        <source>{}: {} nodes lie in the place of another one</source>
        <translation>{}: {} Knoten liegen an der Stelle eines anderen</translation>
    </message>
    <message>
        <source>{}: {} touches none of the edges it is listed for ({})</source>
        <translation>{}: {} berührt keine der Kanten, für die sie genannt ist ({})</translation>
    </message>
    <message>
        <source>{}; {} is the likest to it</source>
        <translation>{}; am ähnlichsten ist ihm {}</translation>
    </message>
</context>
<context>
    <name>App::Property</name>
    <message>
        <source>2 puts a node in the middle of each mesh edge, on the shape.</source>
        <translation>2 setzt einen Knoten in die Mitte jeder Netzkante, auf der Form.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to have more elements is refused before it is begun; 0: two million.</source>
        <translation>Ein Netz, das nach der Schätzung mehr Elemente hat, wird abgelehnt, ehe es begonnen wird; 0: zwei Millionen.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to take more megabytes is refused before it is begun; 0: four fifths of the machine's memory.</source>
        <translation>Ein Netz, das nach der Schätzung mehr Megabyte braucht, wird abgelehnt, ehe es begonnen wird; 0: vier Fünftel des Speichers.</translation>
    </message>
    <message>
        <source>A mesh that is estimated to take more seconds of computing is refused before it is begun; 0: ten minutes.</source>
        <translation>Ein Netz, das nach der Schätzung mehr Sekunden Rechenzeit braucht, wird abgelehnt, ehe es begonnen wird; 0: zehn Minuten.</translation>
    </message>
    <message>
        <source>Air at 15 °C, or water at 20 °C, both at 1 bar.</source>
        <translation>Luft bei 15 °C oder Wasser bei 20 °C, beide bei 1 bar.</translation>
    </message>
    <message>
        <source>Along a plate, a wing, a hull: the distance from its leading edge. In a pipe or a duct: its hydraulic diameter.</source>
        <translation>Entlang einer Platte, eines Flügels, eines Rumpfes: der Abstand von der Vorderkante. In einem Rohr oder Kanal: dessen hydraulischer Durchmesser.</translation>
    </message>
    <message>
        <source>An existing mesh of the shape to start from. Inside the faces its nodes are where the triangulation starts; where it is finer than size, edges and core become as fine. Its layers and its order do not come over.</source>
        <translation>Ein vorhandenes Netz der Form, mit dem begonnen wird. Im Inneren der Flächen sind seine Knoten der Anfang der Triangulierung; wo es feiner ist als die Elementgröße, werden Kanten und Kern ebenso fein. Seine Schichten und seine Ordnung werden nicht übernommen.</translation>
    </message>
    <message>
        <source>Aspect Ratio</source>
        <translation>Seitenverhältnis</translation>
    </message>
    <message>
        <source>Auto Update</source>
        <translation>Automatisch aktualisieren</translation>
    </message>
    <message>
        <source>Both Ends</source>
        <translation>Beide Enden</translation>
    </message>
    <message>
        <source>Cells Across</source>
        <translation>Elemente quer</translation>
    </message>
    <message>
        <source>Chord Deviation</source>
        <translation>Sehnenabweichung</translation>
    </message>
    <message>
        <source>Cluster</source>
        <translation>Verdichtung</translation>
    </message>
    <message>
        <source>Clusters towards both ends: the ratio is then that of the middle to the ends.</source>
        <translation>Verdichtet zu beiden Enden hin: das Verhältnis ist dann das der Mitte zu den Enden.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Core</source>
        <translation>Kern</translation>
    </message>
    <message>
        <source>Corner angles from 45 to 135 degrees [%].</source>
        <translation>Eckenwinkel von 45 bis 135 Grad [%].</translation>
    </message>
    <message>
        <source>Counts and nodes of the initial mesh that the mesh was made from.</source>
        <translation>Anzahlen und Knoten des Ausgangsnetzes, aus dem das Netz entstand.</translation>
    </message>
    <message>
        <source>Curvature Angle</source>
        <translation>Krümmungswinkel</translation>
    </message>
    <message>
        <source>Density of another fluid [kg/m³].</source>
        <translation>Dichte eines anderen Fluids [kg/m³].</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Dimensionless height of the first layer; its middle lies at half of it.</source>
        <translation>Dimensionslose Höhe der ersten Schicht; ihre Mitte liegt bei der Hälfte davon.</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Dynamic viscosity of another fluid [Pa s].</source>
        <translation>Dynamische Viskosität eines anderen Fluids [Pa s].</translation>
    </message>
    <message>
        <source>Each layer is this much higher than the one before it.</source>
        <translation>Jede Schicht ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Each layer of this wall is this much higher than the one before it.</source>
        <translation>Jede Schicht dieser Wand ist um diesen Faktor höher als die vorige.</translation>
    </message>
    <message>
        <source>Each layer of this wall is this much higher than the one before it. 0: not given.</source>
        <translation>Jede Schicht dieser Wand ist um diesen Faktor höher als die vorige. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Edge Segments</source>
        <translation>Kantenabschnitte</translation>
    </message>
    <message>
        <source>Edge length of the mesh away from the layers. Default: 1/40 of the diagonal of the shape's bounding box.</source>
        <translation>Kantenlänge des Netzes abseits der Schichten. Vorgabe: 1/40 der Diagonale des Hüllquaders der Form.</translation>
    </message>
    <message>
        <source>Edge length of the mesh.</source>
        <translation>Kantenlänge des Netzes.</translation>
    </message>
    <message>
        <source>Edge length of the mesh. 0: not given.</source>
        <translation>Kantenlänge des Netzes. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Edges and faces that a motion brings onto others: these are cut and meshed as copies of those; as a property, texts: Face1 move x y z, or Edge1 Edge2 turn x y z x y z angle, with a point on the axis and its direction.</source>
        <translation>Kanten und Flächen, die eine Bewegung auf andere bringt: diese werden als Kopien jener geteilt und vernetzt; als Eigenschaft Texte: Face1 move x y z, oder Edge1 Edge2 turn x y z x y z Winkel, mit einem Punkt der Achse und ihrer Richtung.</translation>
    </message>
    <message>
        <source>Element Layers</source>
        <translation>Schichten der Elemente</translation>
    </message>
    <message>
        <source>Elements turned over against the surface.</source>
        <translation>Gegen die Oberfläche invertierte Elemente.</translation>
    </message>
    <message>
        <source>End Height</source>
        <translation>Endhöhe</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>Flächen</translation>
    </message>
    <message>
        <source>Faces that meet at an angle below this are meshed as one patch; layers run across the edge between them. 0 makes every CAD face a patch of its own; an STL file is meshed with 20.</source>
        <translation>Flächen, die sich in einem kleineren Winkel treffen, werden als eine Teilfläche vernetzt; Schichten laufen über die Kante zwischen ihnen hinweg. Bei 0 ist jede CAD-Fläche eine Teilfläche für sich; eine STL-Datei wird mit 20 vernetzt.</translation>
    </message>
    <message>
        <source>Faces whose edges lie within this distance of each other are joined there before meshing; 0 joins none. Faces and edges keep their names.</source>
        <translation>Flächen, deren Kanten nicht weiter als dies voneinander liegen, werden dort vor dem Vernetzen verbunden; 0 verbindet keine. Flächen und Kanten behalten ihre Namen.</translation>
    </message>
    <message>
        <source>Faces with four sides that are filled with rows and columns of quads from side to side, with the layers of walls along them; facing sides get as many mesh edges.</source>
        <translation>Flächen mit vier Seiten, die mit Zeilen und Spalten von Vierecken von Seite zu Seite gefüllt werden, mit den Schichten der Wände an ihnen; gegenüberliegende Seiten bekommen gleich viele Netzkanten.</translation>
    </message>
    <message>
        <source>Feature Angle</source>
        <translation>Kantenwinkel</translation>
    </message>
    <message>
        <source>First Height</source>
        <translation>Erste Höhe</translation>
    </message>
    <message>
        <source>First Segment</source>
        <translation>Erster Abschnitt</translation>
    </message>
    <message>
        <source>Geometry</source>
        <translation>Geometrie</translation>
    </message>
    <message>
        <source>Good Angle Percent</source>
        <translation>Gute Winkel [%]</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Group List</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>Group Name</source>
        <translation>Gruppenname</translation>
    </message>
    <message>
        <source>Grow From All</source>
        <translation>Von allen Kanten</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wachstumsfaktor</translation>
    </message>
    <message>
        <source>Height Errors</source>
        <translation>Höhenfehler</translation>
    </message>
    <message>
        <source>Height of all layers together. With two of first_height, growth and layers it gives the third; where fewer are given, those of the whole mesh stand in, and layers are worked out first.</source>
        <translation>Höhe aller Schichten zusammen. Mit zweien von erster Höhe, Wachstumsfaktor und Schichtzahl ergibt sie das dritte; sind weniger angegeben, gelten die des ganzen Netzes, und die Schichtzahl wird zuerst berechnet.</translation>
    </message>
    <message>
        <source>Height of all layers together. With two of first_height, growth and layers it gives the third; where fewer are given, those of the whole mesh stand in, and layers are worked out first. 0: not given.</source>
        <translation>Höhe aller Schichten zusammen. Mit zweien von erster Höhe, Wachstumsfaktor und Schichtzahl ergibt sie das dritte; sind weniger angegeben, gelten die des ganzen Netzes, und die Schichtzahl wird zuerst berechnet. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Height of the first layer, measured along the surface. Default: 1/10 of size.</source>
        <translation>Höhe der ersten Schicht, entlang der Oberfläche gemessen. Vorgabe: 1/10 der Elementgröße.</translation>
    </message>
    <message>
        <source>Height of this wall's first layer.</source>
        <translation>Höhe der ersten Schicht dieser Wand.</translation>
    </message>
    <message>
        <source>Height of this wall's first layer. 0: not given.</source>
        <translation>Höhe der ersten Schicht dieser Wand. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>How far the height of each element of a layer is from the one asked for, relative to it; NaN for the core.</source>
        <translation>Wie weit die Höhe jedes Elements einer Schicht von der verlangten abweicht, bezogen auf diese; NaN für den Kern.</translation>
    </message>
    <message>
        <source>How mesh edges grow between first and last segment: smoothly towards both, in geometric steps, or not at all beyond one step.</source>
        <translation>Wie Netzkanten zwischen dem ersten und dem letzten Abschnitt wachsen: glatt zu beiden hin, in geometrischen Schritten oder nach einem Schritt gar nicht.</translation>
    </message>
    <message>
        <source>Initial Mesh</source>
        <translation>Ausgangsnetz</translation>
    </message>
    <message>
        <source>Instead of first_height: the angle that the wall turns over a length of one first height; the height is size where the wall is straight.</source>
        <translation>Statt der ersten Höhe: der Winkel, um den sich die Wand über die Länge einer ersten Höhe dreht; wo die Wand gerade ist, ist die Höhe die Elementgröße.</translation>
    </message>
    <message>
        <source>Instead of first_height: the angle that the wall turns over a length of one first height; the height is size where the wall is straight. 0: not given.</source>
        <translation>Statt der ersten Höhe: der Winkel, um den sich die Wand über die Länge einer ersten Höhe dreht; wo die Wand gerade ist, ist die Höhe die Elementgröße. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Instead of first_height: the length of the mesh edges along the wall over the first height, everywhere.</source>
        <translation>Statt der ersten Höhe: das Verhältnis der Netzkantenlänge entlang der Wand zur ersten Höhe, überall.</translation>
    </message>
    <message>
        <source>Instead of first_height: the length of the mesh edges along the wall over the first height, everywhere. 0: not given.</source>
        <translation>Statt der ersten Höhe: das Verhältnis der Netzkantenlänge entlang der Wand zur ersten Höhe, überall. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Instead of thickness: the height of all layers together over the size along the edge.</source>
        <translation>Statt thickness: die Höhe aller Schichten zusammen, geteilt durch die Größe an der Kante.</translation>
    </message>
    <message>
        <source>Instead of thickness: the height of all layers together over the size along the edge. 0: not given.</source>
        <translation>Statt thickness: die Höhe aller Schichten zusammen, geteilt durch die Größe an der Kante. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Inverted Count</source>
        <translation>Invertierte Elemente</translation>
    </message>
    <message>
        <source>Last Segment</source>
        <translation>Letzter Abschnitt</translation>
    </message>
    <message>
        <source>Layer Groups</source>
        <translation>Gruppen der Schichten</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Schichten</translation>
    </message>
    <message>
        <source>Layers grow from every boundary edge, as long as no Wall of the mesh says otherwise.</source>
        <translation>Schichten wachsen von jeder Randkante, solange keine Wand des Netzes anderes sagt.</translation>
    </message>
    <message>
        <source>Length of the first mesh edge at the first vertex of each CAD edge.</source>
        <translation>Länge der ersten Netzkante am ersten Eckpunkt jeder CAD-Kante.</translation>
    </message>
    <message>
        <source>Length of the first mesh edge at the first vertex of each CAD edge. 0: not given.</source>
        <translation>Länge der ersten Netzkante am ersten Eckpunkt jeder CAD-Kante. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Length of the last mesh edge at the last vertex of each CAD edge.</source>
        <translation>Länge der letzten Netzkante am letzten Eckpunkt jeder CAD-Kante.</translation>
    </message>
    <message>
        <source>Length of the last mesh edge at the last vertex of each CAD edge. 0: not given.</source>
        <translation>Länge der letzten Netzkante am letzten Eckpunkt jeder CAD-Kante. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Makes a group of the elements of each layer, too: Layer1, Layer2, … and Core.</source>
        <translation>Macht auch aus den Elementen jeder Schicht eine Gruppe: Layer1, Layer2, … und Core.</translation>
    </message>
    <message>
        <source>Mapped</source>
        <translation>Abgebildet</translation>
    </message>
    <message>
        <source>Max Angle</source>
        <translation>Größter Winkel</translation>
    </message>
    <message>
        <source>Max Elements</source>
        <translation>Höchste Elementzahl</translation>
    </message>
    <message>
        <source>Max Memory</source>
        <translation>Höchster Speicher</translation>
    </message>
    <message>
        <source>Max Seconds</source>
        <translation>Höchste Rechenzeit</translation>
    </message>
    <message>
        <source>Mesh Id</source>
        <translation>Netzkennung</translation>
    </message>
    <message>
        <source>Mesh edges on CAD edges: the edge and two nodes, counted from 0, of each.</source>
        <translation>Netzkanten auf CAD-Kanten: von jeder die Kante und zwei Knoten, von 0 an gezählt.</translation>
    </message>
    <message>
        <source>Meshed Constraints</source>
        <translation>Vernetzte Randbedingungen</translation>
    </message>
    <message>
        <source>Meshed Initial Mesh</source>
        <translation>Vernetztes Ausgangsnetz</translation>
    </message>
    <message>
        <source>Meshed Settings</source>
        <translation>Vernetzte Einstellungen</translation>
    </message>
    <message>
        <source>Meshed Shape</source>
        <translation>Vernetzte Form</translation>
    </message>
    <message>
        <source>Meshes again whenever a recompute finds the mesh out of date.</source>
        <translation>Vernetzt neu, sooft eine Neuberechnung das Netz veraltet findet.</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Min Angle</source>
        <translation>Kleinster Winkel</translation>
    </message>
    <message>
        <source>Min Size</source>
        <translation>Kleinste Größe</translation>
    </message>
    <message>
        <source>Node Count</source>
        <translation>Knotenzahl</translation>
    </message>
    <message>
        <source>Node Layers</source>
        <translation>Schichten der Knoten</translation>
    </message>
    <message>
        <source>Node Parents</source>
        <translation>Eltern der Knoten</translation>
    </message>
    <message>
        <source>Nodes of the mesh.</source>
        <translation>Knoten des Netzes.</translation>
    </message>
    <message>
        <source>Number of layers; 0 grows them until the fronts close; "isotropic" grows each until its height reaches the spacing along the wall.</source>
        <translation>Zahl der Schichten; bei 0 wachsen sie, bis die Fronten sich schließen; bei "isotropic", bis ihre Höhe den Abstand entlang der Wand erreicht.</translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges.</source>
        <translation>Zahl der Netzkanten entlang jeder der Kanten.</translation>
    </message>
    <message>
        <source>Number of mesh edges along each of the edges. 0: not given.</source>
        <translation>Zahl der Netzkanten entlang jeder der Kanten. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>Number of this wall's layers; 0 grows them until the fronts close.</source>
        <translation>Zahl der Schichten dieser Wand; bei 0 wachsen sie, bis die Fronten sich schließen.</translation>
    </message>
    <message>
        <source>Number of this wall's layers; 0 grows them until the fronts close. -1: not given.</source>
        <translation>Zahl der Schichten dieser Wand; bei 0 wachsen sie, bis die Fronten sich schließen. -1: nicht angegeben.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>Übrige</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Teil</translation>
    </message>
    <message>
        <source>Past a plate, or developed in a pipe.</source>
        <translation>An einer Platte entlang oder ausgebildet in einem Rohr.</translation>
    </message>
    <message>
        <source>Periodic</source>
        <translation>Periodisch</translation>
    </message>
    <message>
        <source>Picked</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>Points of the shape that was meshed.</source>
        <translation>Punkte der vernetzten Form.</translation>
    </message>
    <message>
        <source>Points, lines and boxes about which the mesh is finer; as a property, texts: x y z size radius, or line x y z x y z size radius, or box x y z x y z size radius.</source>
        <translation>Punkte, Strecken und Quader, um die das Netz feiner ist; als Eigenschaft Texte: x y z Größe Radius, oder line x y z x y z Größe Radius, oder box x y z x y z Größe Radius.</translation>
    </message>
    <message>
        <source>Quad Count</source>
        <translation>Zahl der Vierecke</translation>
    </message>
    <message>
        <source>Quad Percent</source>
        <translation>Vierecke [%]</translation>
    </message>
    <message>
        <source>Quads among all elements [%].</source>
        <translation>Anteil der Vierecke an allen Elementen [%].</translation>
    </message>
    <message>
        <source>Quads of the mesh.</source>
        <translation>Vierecke des Netzes.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first, in geometric steps.</source>
        <translation>Verhältnis der letzten Netzkante entlang einer CAD-Kante zur ersten, in geometrischen Schritten.</translation>
    </message>
    <message>
        <source>Ratio of the last mesh edge along a CAD edge to the first, in geometric steps. 0: not given.</source>
        <translation>Verhältnis der letzten Netzkante entlang einer CAD-Kante zur ersten, in geometrischen Schritten. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>References</source>
        <translation>Referenzen</translation>
    </message>
    <message>
        <source>Refinements</source>
        <translation>Verfeinerungen</translation>
    </message>
    <message>
        <source>Relative Chord</source>
        <translation>Relative Sehne</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Ausführung</translation>
    </message>
    <message>
        <source>Schema Version</source>
        <translation>Schemafassung</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Abschnitte</translation>
    </message>
    <message>
        <source>Sew Tolerance</source>
        <translation>Nähtoleranz</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Size Growth</source>
        <translation>Größenwachstum</translation>
    </message>
    <message>
        <source>Size List</source>
        <translation>Größen</translation>
    </message>
    <message>
        <source>Speed of the flow [m/s].</source>
        <translation>Geschwindigkeit der Strömung [m/s].</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Tells this mesh from the ones before it.</source>
        <translation>Unterscheidet dieses Netz von den vorigen.</translation>
    </message>
    <message>
        <source>The CAD faces to mesh, by name, or all of them.</source>
        <translation>Die zu vernetzenden CAD-Flächen, mit Namen, oder alle.</translation>
    </message>
    <message>
        <source>The constraints of analyses that the mesh has groups for, each with its faces.</source>
        <translation>Die Randbedingungen von Analysen, für die das Netz Gruppen hat, jede mit ihren Flächen.</translation>
    </message>
    <message>
        <source>The edges that the values hold for. With faces too: only on the side of those faces. Faces alone: all their boundary edges, on their side.</source>
        <translation>Die Kanten, für die die Werte gelten. Mit Flächen dazu: nur auf der Seite dieser Flächen. Flächen allein: alle ihre Randkanten, auf ihrer Seite.</translation>
    </message>
    <message>
        <source>The faces and edges of the group; the mesh groups them under its label.</source>
        <translation>Die Flächen und Kanten der Gruppe; im Netz tragen sie deren Bezeichnung.</translation>
    </message>
    <message>
        <source>The faces, edges and vertices that the size holds for.</source>
        <translation>Die Flächen, Kanten und Eckpunkte, für die die Elementgröße gilt.</translation>
    </message>
    <message>
        <source>The first height at the end of each edge; it changes linearly along the edge, from first_height at its first vertex.</source>
        <translation>Die erste Höhe am Ende jeder Kante; sie ändert sich linear entlang der Kante, ausgehend von der ersten Höhe am ersten Eckpunkt.</translation>
    </message>
    <message>
        <source>The first height at the end of each edge; it changes linearly along the edge, from first_height at its first vertex. 0: not given.</source>
        <translation>Die erste Höhe am Ende jeder Kante; sie ändert sich linear entlang der Kante, ausgehend von der ersten Höhe am ersten Eckpunkt. 0: nicht angegeben.</translation>
    </message>
    <message>
        <source>The group's name in the mesh; the label, unless another is given here.</source>
        <translation>Der Name der Gruppe im Netz; die Bezeichnung, wenn hier kein anderer angegeben ist.</translation>
    </message>
    <message>
        <source>The largest corner angle.</source>
        <translation>Der größte Eckenwinkel.</translation>
    </message>
    <message>
        <source>The layer of each element; 0 for the core.</source>
        <translation>Die Schicht jedes Elements; 0 für den Kern.</translation>
    </message>
    <message>
        <source>The layer that each node was extruded in; else 0.</source>
        <translation>Die Schicht, in der jeder Knoten entstand; sonst 0.</translation>
    </message>
    <message>
        <source>The least edge length that curvature and chords may ask for; 0: any. Sizes of edges, faces and regions are not held to it.</source>
        <translation>Die kleinste Kantenlänge, die Krümmung und Sehnen verlangen dürfen; 0: jede. Für Größen von Kanten, Flächen und Gebieten gilt sie nicht.</translation>
    </message>
    <message>
        <source>The least number of elements over the extent of each face, however small it is beside the whole, down to a tenth of size; a small outline inside a plane face, such as an airfoil in its domain, gets twelve times as many around it, fewer where there are several. First heights of a tenth of size or more are held to a tenth of the mesh edges along their wall. 0: none. Default: 10 where neither size nor first_height is given.</source>
        <translation>Die kleinste Zahl von Elementen über die Ausdehnung jeder Fläche, wie klein sie neben dem Ganzen auch ist, bis hinab zu einem Zehntel der Größe; ein kleiner Umriss in einer ebenen Fläche, etwa ein Profil in seinem Gebiet, bekommt zwölfmal so viele um sich herum, bei mehreren weniger. Erste Höhen von einem Zehntel der Größe oder mehr werden auf ein Zehntel der Netzkanten ihrer Wand gesenkt. 0: keine. Vorgabe: 10, wo weder size noch first_height angegeben ist.</translation>
    </message>
    <message>
        <source>The local sizes of the mesh.</source>
        <translation>Die örtlichen Elementgrößen des Netzes.</translation>
    </message>
    <message>
        <source>The most that neighbouring mesh edges differ in length where the size changes, through the surface and along edges.</source>
        <translation>Der Faktor, um den sich benachbarte Netzkanten höchstens in der Länge unterscheiden, wo die Elementgröße wechselt, in der Fläche und entlang von Kanten.</translation>
    </message>
    <message>
        <source>The most that one element edge may turn along a curved edge or face; finer than size where the shape is curved.</source>
        <translation>Um wie viel sich eine Elementkante entlang einer gekrümmten Kante oder Fläche höchstens drehen darf; feiner als die Elementgröße, wo die Form gekrümmt ist.</translation>
    </message>
    <message>
        <source>The most that the middle of a mesh edge may lie off the curve or surface that it stands for; 0: any.</source>
        <translation>Wie weit die Mitte einer Netzkante höchstens neben der Kurve oder Fläche liegen darf, für die sie steht; 0: beliebig.</translation>
    </message>
    <message>
        <source>The named groups of the mesh.</source>
        <translation>Die benannten Gruppen des Netzes.</translation>
    </message>
    <message>
        <source>The node, counted from 0, that each node was extruded from; else -1.</source>
        <translation>Der Knoten, von 0 gezählt, aus dem jeder Knoten entstand; sonst -1.</translation>
    </message>
    <message>
        <source>The object that is meshed.</source>
        <translation>Das Objekt, das vernetzt ist.</translation>
    </message>
    <message>
        <source>The object whose faces are meshed.</source>
        <translation>Das Objekt, dessen Flächen vernetzt werden.</translation>
    </message>
    <message>
        <source>The report of the mesh, as a job writes it.</source>
        <translation>Der Bericht über das Netz, wie ein Stapelauftrag ihn schreibt.</translation>
    </message>
    <message>
        <source>The same over the length of the mesh edge; 0: any.</source>
        <translation>Dasselbe, geteilt durch die Länge der Netzkante; 0: beliebig.</translation>
    </message>
    <message>
        <source>The settings that the mesh was made with.</source>
        <translation>Die Einstellungen, mit denen das Netz erzeugt wurde.</translation>
    </message>
    <message>
        <source>The size holds within this distance of the point.</source>
        <translation>Die Elementgröße gilt bis zu diesem Abstand vom Punkt.</translation>
    </message>
    <message>
        <source>The smallest corner angle.</source>
        <translation>Der kleinste Eckenwinkel.</translation>
    </message>
    <message>
        <source>The walls of the mesh.</source>
        <translation>Die Wände des Netzes.</translation>
    </message>
    <message>
        <source>The way in which the object keeps its data.</source>
        <translation>Die Art, in der das Objekt seine Daten ablegt.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thickness Share</source>
        <translation>Dickenanteil</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Threads</translation>
    </message>
    <message>
        <source>Threads to mesh with; 0 uses all processors. The mesh does not depend on it.</source>
        <translation>Threads für die Vernetzung; 0 nutzt alle Prozessoren. Das Netz hängt nicht davon ab.</translation>
    </message>
    <message>
        <source>Triangle Count</source>
        <translation>Zahl der Dreiecke</translation>
    </message>
    <message>
        <source>Triangles of the mesh.</source>
        <translation>Dreiecke des Netzes.</translation>
    </message>
    <message>
        <source>Turning Angle</source>
        <translation>Drehwinkel</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>Wand</translation>
    </message>
    <message>
        <source>Wall List</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Wall: layers grow from the edges. Match: layers of other walls run along them. Off: neither. Boundary: they bound their faces, however smoothly these meet. Smooth: layers run across them.</source>
        <translation>Wand (Wall): Schichten wachsen von den Kanten. Entlang (Match): Schichten anderer Wände laufen an ihnen entlang. Aus (Off): keins von beidem. Rand (Boundary): sie begrenzen ihre Flächen, wie glatt diese auch aneinander stoßen. Glatt (Smooth): Schichten laufen über sie hinweg.</translation>
    </message>
    <message>
        <source>What becomes of boundary edges that a list of walls leaves out: those that meet a wall are match edges, or all are off, or all are walls of the mesh's own values.</source>
        <translation>Was aus Randkanten wird, die eine Liste von Wänden auslässt: solche, die eine Wand berühren, werden Anschlusskanten (match), oder alle sind aus (off), oder alle sind Wände mit den Werten des Netzes (wall).</translation>
    </message>
    <message>
        <source>What fills the part that no layer reaches: quads where they come out well, or triangles.</source>
        <translation>Was den Teil füllt, den keine Schicht erreicht: Vierecke, wo sie gut werden, oder Dreiecke.</translation>
    </message>
    <message>
        <source>What is asked for where nothing else is said: cfd grows layers from every sharp edge until they are as high as wide, fem has none, washers puts two rings of quads about every hole.</source>
        <translation>Was gilt, wo nichts anderes gesagt ist: CFD lässt Schichten von jeder scharfen Kante wachsen, bis sie so hoch wie breit sind, FEM hat keine, Scheiben legt zwei Ringe aus Vierecken um jedes Loch.</translation>
    </message>
    <message>
        <source>What the faces looked like when they were picked.</source>
        <translation>Wie die Flächen aussahen, als sie gewählt wurden.</translation>
    </message>
    <message>
        <source>What the mesher had to say.</source>
        <translation>Was der Vernetzer zu sagen hatte.</translation>
    </message>
    <message>
        <source>What the references looked like when they were picked.</source>
        <translation>Wie das Gewählte aussah, als es gewählt wurde.</translation>
    </message>
    <message>
        <source>Whether the mesh fits the settings and the shape.</source>
        <translation>Ob das Netz zu den Einstellungen und zur Form passt.</translation>
    </message>
</context>
<context>
    <name>Workbench</name>
    <message>
        <source>Advancing Layers</source>
        <translation>Advancing Layers</translation>
    </message>
</context>
</TS>
