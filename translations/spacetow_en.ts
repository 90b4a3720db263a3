<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>messages</name>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>Move %n object</numerusform>
            <numerusform>Move %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n objects</source>
        <translation>
            <numerusform>Rotate %n object</numerusform>
            <numerusform>Rotate %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reverse %n objects</source>
        <translation>
            <numerusform>Reverse %n object</numerusform>
            <numerusform>Reverse %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>Delete %n object</numerusform>
            <numerusform>Delete %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n objects</source>
        <translation>
            <numerusform>Duplicate %n object</numerusform>
            <numerusform>Duplicate %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Cut %n objects</source>
        <translation>
            <numerusform>Cut %n object</numerusform>
            <numerusform>Cut %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change %n objects</source>
        <translation>
            <numerusform>Change %n object</numerusform>
            <numerusform>Change %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Paste %n objects</source>
        <translation>
            <numerusform>Paste %n object</numerusform>
            <numerusform>Paste %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n objects</source>
        <translation>
            <numerusform>Scale %n object</numerusform>
            <numerusform>Scale %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Flip %n objects</source>
        <translation>
            <numerusform>Flip %n object</numerusform>
            <numerusform>Flip %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Align %n objects</source>
        <translation>
            <numerusform>Align %n object</numerusform>
            <numerusform>Align %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n objects</source>
        <translation>
            <numerusform>Distribute %n object</numerusform>
            <numerusform>Distribute %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Reorder %n objects</source>
        <translation>
            <numerusform>Reorder %n object</numerusform>
            <numerusform>Reorder %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Group %n objects</source>
        <translation>
            <numerusform>Group %n object</numerusform>
            <numerusform>Group %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n groups</source>
        <translation>
            <numerusform>Ungroup %n group</numerusform>
            <numerusform>Ungroup %n groups</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another layer</source>
        <translation>
            <numerusform>Move %n object to another layer</numerusform>
            <numerusform>Move %n objects to another layer</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Hide %n objects</source>
        <translation>
            <numerusform>Hide %n object</numerusform>
            <numerusform>Hide %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Isolate %n objects</source>
        <translation>
            <numerusform>Isolate %n object</numerusform>
            <numerusform>Isolate %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Lock %n objects</source>
        <translation>
            <numerusform>Lock %n object</numerusform>
            <numerusform>Lock %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Repeat transform of %n objects</source>
        <translation>
            <numerusform>Repeat transform of %n object</numerusform>
            <numerusform>Repeat transform of %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Array of %n copies</source>
        <translation>
            <numerusform>Array of %n copy</numerusform>
            <numerusform>Array of %n copies</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unite %n objects</source>
        <translation>
            <numerusform>Unite %n object</numerusform>
            <numerusform>Unite %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Subtract %n objects</source>
        <translation>
            <numerusform>Subtract %n object</numerusform>
            <numerusform>Subtract %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Intersect %n objects</source>
        <translation>
            <numerusform>Intersect %n object</numerusform>
            <numerusform>Intersect %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>Move %n node</numerusform>
            <numerusform>Move %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n nodes</source>
        <translation>
            <numerusform>Rotate %n node</numerusform>
            <numerusform>Rotate %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Scale %n nodes</source>
        <translation>
            <numerusform>Scale %n node</numerusform>
            <numerusform>Scale %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n nodes</source>
        <translation>
            <numerusform>Delete %n node</numerusform>
            <numerusform>Delete %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Break at %n nodes</source>
        <translation>
            <numerusform>Break at %n node</numerusform>
            <numerusform>Break at %n nodes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another group</source>
        <translation>
            <numerusform>Move %n object to another group</numerusform>
            <numerusform>Move %n objects to another group</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Show %n objects</source>
        <translation>
            <numerusform>Show %n object</numerusform>
            <numerusform>Show %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n objects</source>
        <translation>
            <numerusform>Unlock %n object</numerusform>
            <numerusform>Unlock %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Take over %n objects</source>
        <translation>
            <numerusform>Take over %n object</numerusform>
            <numerusform>Take over %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n objects</source>
        <translation>
            <numerusform>Import %n object</numerusform>
            <numerusform>Import %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n time</numerusform>
            <numerusform>%n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Keep %n changes</source>
        <translation>
            <numerusform>Keep %n change</numerusform>
            <numerusform>Keep %n changes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Change “%1” of %n objects</source>
        <translation>
            <numerusform>Change “%1” of %n object</numerusform>
            <numerusform>Change “%1” of %n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::DifferencePanel</name>
    <message numerus="yes">
        <source>%n differences from %1</source>
        <translation>
            <numerusform>%n difference from %1</numerusform>
            <numerusform>%n differences from %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryModel</name>
    <message numerus="yes">
        <source>%n older changes that can no longer be undone</source>
        <translation>
            <numerusform>%n older change that can no longer be undone</numerusform>
            <numerusform>%n older changes that can no longer be undone</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::Inspector</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n shapes</source>
        <translation>
            <numerusform>The shape (%n)</numerusform>
            <numerusform>All %n shapes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n nodes selected</source>
        <translation>
            <numerusform>%1, %n node selected</numerusform>
            <numerusform>%1, %n nodes selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n of the values would leave the range of the field, so nothing has changed.</source>
        <translation>
            <numerusform>%n of the values would leave the range of the field, so nothing has changed.</numerusform>
            <numerusform>%n of the values would leave the range of the field, so nothing has changed.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::MainWindow</name>
    <message numerus="yes">
        <source>The level has %n errors and may not play as it should; see Problems.</source>
        <translation>
            <numerusform>The level has %n error and may not play as it should; see Problems.</numerusform>
            <numerusform>The level has %n errors and may not play as it should; see Problems.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryRow</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesPanel</name>
    <message numerus="yes">
        <source>%n changes were made in this run. The level is as before; keep what you like.</source>
        <translation>
            <numerusform>%n change was made in this run. The level is as before; keep what you like.</numerusform>
            <numerusform>%n changes were made in this run. The level is as before; keep what you like.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::StatusLine</name>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>%n selected</numerusform>
            <numerusform>%n selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n error</numerusform>
            <numerusform>%n errors</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixView</name>
    <message numerus="yes">
        <source>%n objects are “%1”; double-click to select them, right-click for more</source>
        <translation>
            <numerusform>%n object is “%1”; double-click to select it, right-click for more</numerusform>
            <numerusform>%n objects are “%1”; double-click to select them, right-click for more</numerusform>
        </translation>
    </message>
</context>
</TS>
