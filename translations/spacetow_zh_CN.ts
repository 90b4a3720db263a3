<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Not while a game is running.</source>
        <translation>游戏运行时不可用。</translation>
    </message>
    <message>
        <source>Only while a game is running.</source>
        <translation>仅在游戏运行时可用。</translation>
    </message>
    <message>
        <source>Select something first.</source>
        <translation>请先选择对象。</translation>
    </message>
    <message>
        <source>Select at least two objects first.</source>
        <translation>请先选择至少两个对象。</translation>
    </message>
    <message>
        <source>Select nodes first, with the node tool.</source>
        <translation>请先用节点工具选择节点。</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>编组(&amp;G)</translation>
    </message>
    <message>
        <source>Make one thing of what is selected; a double click gets at its parts</source>
        <translation>把所选对象合成一个整体；双击可编辑其中的部分</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>取消编组(&amp;U)</translation>
    </message>
    <message>
        <source>Take the selected groups apart</source>
        <translation>拆开所选的组</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隐藏(&amp;H)</translation>
    </message>
    <message>
        <source>Show the selection no longer; it is played all the same</source>
        <translation>不再显示所选对象；游戏中仍然有效</translation>
    </message>
    <message>
        <source>&amp;Isolate</source>
        <translation>单独显示(&amp;I)</translation>
    </message>
    <message>
        <source>Hide everything but the selection</source>
        <translation>隐藏所选对象以外的一切</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>全部显示(&amp;W)</translation>
    </message>
    <message>
        <source>Show everything that is hidden</source>
        <translation>显示所有已隐藏的对象</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>锁定(&amp;L)</translation>
    </message>
    <message>
        <source>Keep the selection from being selected, moved and removed</source>
        <translation>使所选对象不能被选择、移动和删除</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>全部解锁(&amp;N)</translation>
    </message>
    <message>
        <source>Let everything that is locked be changed again</source>
        <translation>让所有已锁定的对象可以再次更改</translation>
    </message>
    <message>
        <source>To &amp;Front</source>
        <translation>移到最前面(&amp;F)</translation>
    </message>
    <message>
        <source>Draw the selection above everything</source>
        <translation>把所选对象绘制在最上面</translation>
    </message>
    <message>
        <source>F&amp;orward</source>
        <translation>前移(&amp;O)</translation>
    </message>
    <message>
        <source>Draw the selection above the next object that overlaps it</source>
        <translation>把所选对象绘制到上面下一个重叠对象之上</translation>
    </message>
    <message>
        <source>&amp;Backward</source>
        <translation>后移(&amp;B)</translation>
    </message>
    <message>
        <source>Draw the selection below the next object that overlaps it</source>
        <translation>把所选对象绘制到下面下一个重叠对象之下</translation>
    </message>
    <message>
        <source>To Ba&amp;ck</source>
        <translation>移到最后面(&amp;C)</translation>
    </message>
    <message>
        <source>Draw the selection below everything</source>
        <translation>把所选对象绘制在最下面</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>左边缘(&amp;L)</translation>
    </message>
    <message>
        <source>Bring the left edges of the selected objects to that of the leftmost</source>
        <translation>把所选对象的左边缘对齐到最左的一个</translation>
    </message>
    <message>
        <source>&amp;Centers on a Vertical Line</source>
        <translation>中心对齐到垂直线(&amp;C)</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects above each other</source>
        <translation>把所选对象的中心上下对齐</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>右边缘(&amp;R)</translation>
    </message>
    <message>
        <source>Bring the right edges of the selected objects to that of the rightmost</source>
        <translation>把所选对象的右边缘对齐到最右的一个</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>上边缘(&amp;T)</translation>
    </message>
    <message>
        <source>Bring the top edges of the selected objects to that of the highest</source>
        <translation>把所选对象的上边缘对齐到最高的一个</translation>
    </message>
    <message>
        <source>C&amp;enters on a Horizontal Line</source>
        <translation>中心对齐到水平线(&amp;E)</translation>
    </message>
    <message>
        <source>Bring the centers of the selected objects beside each other</source>
        <translation>把所选对象的中心左右对齐</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>下边缘(&amp;B)</translation>
    </message>
    <message>
        <source>Bring the bottom edges of the selected objects to that of the lowest</source>
        <translation>把所选对象的下边缘对齐到最低的一个</translation>
    </message>
    <message>
        <source>Space Left Edges Evenly</source>
        <translation>左边缘等距分布</translation>
    </message>
    <message>
        <source>Distribute the left edges between those of the outermost objects</source>
        <translation>在最外侧对象之间均匀分布左边缘</translation>
    </message>
    <message>
        <source>Space Centers Evenly Across</source>
        <translation>中心水平等距分布</translation>
    </message>
    <message>
        <source>Distribute the centers from left to right</source>
        <translation>从左到右均匀分布中心</translation>
    </message>
    <message>
        <source>Make &amp;Gaps Across Equal</source>
        <translation>水平间隙相等(&amp;G)</translation>
    </message>
    <message>
        <source>Distribute the objects from left to right with the same gap between them</source>
        <translation>从左到右分布对象，使间隙相等</translation>
    </message>
    <message>
        <source>Space Bottom Edges Evenly</source>
        <translation>下边缘等距分布</translation>
    </message>
    <message>
        <source>Distribute the bottom edges between those of the outermost objects</source>
        <translation>在最外侧对象之间均匀分布下边缘</translation>
    </message>
    <message>
        <source>Space Centers Evenly Upwards</source>
        <translation>中心垂直等距分布</translation>
    </message>
    <message>
        <source>Distribute the centers from bottom to top</source>
        <translation>从下到上均匀分布中心</translation>
    </message>
    <message>
        <source>Make Gaps &amp;Upwards Equal</source>
        <translation>垂直间隙相等(&amp;U)</translation>
    </message>
    <message>
        <source>Distribute the objects from bottom to top with the same gap between them</source>
        <translation>从下到上分布对象，使间隙相等</translation>
    </message>
    <message>
        <source>New &amp;Layer</source>
        <translation>新建图层(&amp;L)</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Above</source>
        <translation>移到上一图层(&amp;A)</translation>
    </message>
    <message>
        <source>Move the selection to the next higher layer</source>
        <translation>把所选对象移到上面的图层</translation>
    </message>
    <message>
        <source>Move to Layer &amp;Below</source>
        <translation>移到下一图层(&amp;B)</translation>
    </message>
    <message>
        <source>Move the selection to the next lower layer, or out of all layers</source>
        <translation>把所选对象移到下面的图层，或移出所有图层</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>并集(&amp;U)</translation>
    </message>
    <message>
        <source>Make one body of the selected polygons</source>
        <translation>把所选多边形合成一个物体</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>差集(&amp;D)</translation>
    </message>
    <message>
        <source>Cut the upper polygons out of the lowest one</source>
        <translation>从最下面的多边形中切去上面的多边形</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>交集(&amp;I)</translation>
    </message>
    <message>
        <source>Keep what the selected polygons have in common</source>
        <translation>保留所选多边形的公共部分</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>撤销上一次更改</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>Make the change again</source>
        <translation>重新执行该更改</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>剪切(&amp;T)</translation>
    </message>
    <message>
        <source>Move the selection to the clipboard</source>
        <translation>把所选对象移到剪贴板</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>复制(&amp;C)</translation>
    </message>
    <message>
        <source>Copy the selection to the clipboard as text</source>
        <translation>把所选对象以文本形式复制到剪贴板</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>粘贴(&amp;P)</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard at the pointer</source>
        <translation>把剪贴板内容插入到指针处</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>原位粘贴(&amp;I)</translation>
    </message>
    <message>
        <source>Insert what is on the clipboard where it was copied</source>
        <translation>把剪贴板内容插入到复制时的位置</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>创建副本(&amp;D)</translation>
    </message>
    <message>
        <source>Copy the selection one grid step away</source>
        <translation>在一个网格步长之外复制所选对象</translation>
    </message>
    <message>
        <source>Duplicat&amp;e in Place</source>
        <translation>原位创建副本(&amp;L)</translation>
    </message>
    <message>
        <source>Copy the selection onto itself; what is done to the copy can be repeated</source>
        <translation>在原位复制所选对象；对副本的操作可以重复</translation>
    </message>
    <message>
        <source>De&amp;lete</source>
        <translation>删除(&amp;E)</translation>
    </message>
    <message>
        <source>Remove the selection</source>
        <translation>删除所选对象</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>全选(&amp;A)</translation>
    </message>
    <message>
        <source>Select every object</source>
        <translation>选择所有对象</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>取消选择(&amp;N)</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>不选择任何对象</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>反选(&amp;V)</translation>
    </message>
    <message>
        <source>Select what is not selected</source>
        <translation>选择未选中的对象</translation>
    </message>
    <message>
        <source>Select Same &amp;Kind</source>
        <translation>选择同类型对象(&amp;K)</translation>
    </message>
    <message>
        <source>Select all objects of the same kind as those selected</source>
        <translation>选择与所选对象类型相同的所有对象</translation>
    </message>
    <message>
        <source>Select Same Ta&amp;gs</source>
        <translation>选择同标签对象(&amp;G)</translation>
    </message>
    <message>
        <source>Select all bodies with the same tags as those selected</source>
        <translation>选择与所选物体标签相同的所有物体</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>Add an SVG drawing, a map of Tiled or a scene of R.U.B.E. to the level</source>
        <translation>把 SVG 图形、Tiled 地图或 R.U.B.E. 场景加入关卡</translation>
    </message>
    <message>
        <source>&amp;Export As…</source>
        <translation>导出为(&amp;E)…</translation>
    </message>
    <message>
        <source>Write a picture of the level, as PNG or SVG</source>
        <translation>把关卡输出为 PNG 或 SVG 图片</translation>
    </message>
    <message>
        <source>E&amp;xport Again</source>
        <translation>再次导出(&amp;X)</translation>
    </message>
    <message>
        <source>Write the picture once more, to the same file in the same way</source>
        <translation>以相同方式把图片再次写入同一文件</translation>
    </message>
    <message>
        <source>Screens&amp;hot</source>
        <translation>截图(&amp;R)</translation>
    </message>
    <message>
        <source>Write what the canvas shows to your pictures</source>
        <translation>把画布显示的内容保存到您的图片文件夹</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>新建(&amp;N)</translation>
    </message>
    <message>
        <source>Start an empty level</source>
        <translation>新建空关卡</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a level file</source>
        <translation>打开关卡文件</translation>
    </message>
    <message>
        <source>Reopen Closed &amp;Level</source>
        <translation>重新打开已关闭的关卡(&amp;L)</translation>
    </message>
    <message>
        <source>Open again the level that was closed last</source>
        <translation>再次打开最近关闭的关卡</translation>
    </message>
    <message>
        <source>Q&amp;uick Open…</source>
        <translation>快速打开(&amp;Q)…</translation>
    </message>
    <message>
        <source>Find a level by a few letters of its name: recent ones, those beside it, and those that come with the program</source>
        <translation>用名称中的几个字母查找关卡：最近的、同文件夹的和程序自带的</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Write the level to its file</source>
        <translation>把关卡写入其文件</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>另存为(&amp;A)…</translation>
    </message>
    <message>
        <source>Write the level to another file</source>
        <translation>把关卡写入另一个文件</translation>
    </message>
    <message>
        <source>Reloa&amp;d</source>
        <translation>重新加载(&amp;D)</translation>
    </message>
    <message>
        <source>Read the level from its file again; Undo brings back what it is now</source>
        <translation>从文件重新读取关卡；撤销可恢复现在的状态</translation>
    </message>
    <message>
        <source>Reco&amp;ver Unsaved Work…</source>
        <translation>恢复未保存的工作(&amp;V)…</translation>
    </message>
    <message>
        <source>Show what was left unsaved when the program ended all of a sudden</source>
        <translation>显示程序意外结束时未保存的内容</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Close this level and its window</source>
        <translation>关闭此关卡及其窗口</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;U)</translation>
    </message>
    <message>
        <source>Close all windows and leave the program</source>
        <translation>关闭所有窗口并退出程序</translation>
    </message>
    <message>
        <source>&amp;Find Action…</source>
        <translation>查找操作(&amp;F)…</translation>
    </message>
    <message>
        <source>Find actions, panels, levels, objects and problems by a few letters</source>
        <translation>用几个字母查找操作、面板、关卡、对象和问题</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>按键一览(&amp;K)…</translation>
    </message>
    <message>
        <source>Show what the keys do</source>
        <translation>显示各按键的作用</translation>
    </message>
    <message>
        <source>Keyboard &amp;Shortcuts…</source>
        <translation>键盘快捷键(&amp;S)…</translation>
    </message>
    <message>
        <source>Give other keys to actions, or the keys of Tiled, Inkscape or Blender</source>
        <translation>为操作指定其他按键，或采用 Tiled、Inkscape、Blender 的按键</translation>
    </message>
    <message>
        <source>&amp;About SpaceTow Studio…</source>
        <translation>关于 SpaceTow Studio(&amp;A)…</translation>
    </message>
    <message>
        <source>Show version and license</source>
        <translation>显示版本和许可证</translation>
    </message>
    <message>
        <source>&amp;Next Problem</source>
        <translation>下一个问题(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next problem of the level</source>
        <translation>转到关卡的下一个问题</translation>
    </message>
    <message>
        <source>&amp;Previous Problem</source>
        <translation>上一个问题(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the problem before</source>
        <translation>转到前一个问题</translation>
    </message>
    <message>
        <source>&amp;Fix Problem</source>
        <translation>修复问题(&amp;F)</translation>
    </message>
    <message>
        <source>Cure the problem that was gone to last, where there is a fix for it</source>
        <translation>修复最近转到的问题（如有修复方法）</translation>
    </message>
    <message>
        <source>Fix All &amp;Safe Problems</source>
        <translation>修复所有安全的问题(&amp;I)</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>修复所有不会改变设计意图的问题</translation>
    </message>
    <message>
        <source>&amp;Hide Problem</source>
        <translation>隐藏问题(&amp;H)</translation>
    </message>
    <message>
        <source>Never show the problem that was gone to last in this level, or show it again</source>
        <translation>在此关卡中不再显示最近转到的问题，或重新显示</translation>
    </message>
    <message>
        <source>Insert &amp;Midpoints</source>
        <translation>插入中点(&amp;M)</translation>
    </message>
    <message>
        <source>Insert a node in the middle of each selected segment, or of all</source>
        <translation>在每条所选线段（或所有线段）中间插入节点</translation>
    </message>
    <message>
        <source>D&amp;elete Segments</source>
        <translation>删除线段(&amp;E)</translation>
    </message>
    <message>
        <source>Remove the segments between selected nodes and leave the chain open there</source>
        <translation>删除所选节点之间的线段，使链在此处断开</translation>
    </message>
    <message>
        <source>Select two nodes next to each other first, with the node tool.</source>
        <translation>请先用节点工具选择两个相邻的节点。</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>连接节点(&amp;J)</translation>
    </message>
    <message>
        <source>Weld two end nodes, or two neighbours, into one in the middle</source>
        <translation>把两个端点或相邻节点并为正中的一个</translation>
    </message>
    <message>
        <source>Select two ends of walls or lines first, with the node tool.</source>
        <translation>请先用节点工具选择墙或线的两个端点。</translation>
    </message>
    <message>
        <source>Join by a &amp;Segment</source>
        <translation>用线段连接(&amp;S)</translation>
    </message>
    <message>
        <source>Join two end nodes by a new segment</source>
        <translation>用新线段连接两个端点</translation>
    </message>
    <message>
        <source>&amp;Break at Nodes</source>
        <translation>在节点处断开(&amp;B)</translation>
    </message>
    <message>
        <source>Split chains at the selected nodes, open closed ones</source>
        <translation>在所选节点处拆分链，打开闭合的链</translation>
    </message>
    <message>
        <source>Make S&amp;traight in 15° Steps</source>
        <translation>按 15° 步进拉直(&amp;T)</translation>
    </message>
    <message>
        <source>Turn the selected segments to the nearest multiple of 15°</source>
        <translation>把所选线段转到最接近的 15° 倍数</translation>
    </message>
    <message>
        <source>&amp;Next Node</source>
        <translation>下一个节点(&amp;N)</translation>
    </message>
    <message>
        <source>Select the next node</source>
        <translation>选择下一个节点</translation>
    </message>
    <message>
        <source>Take the node tool and select an object first.</source>
        <translation>请先切换到节点工具并选择对象。</translation>
    </message>
    <message>
        <source>&amp;Previous Node</source>
        <translation>上一个节点(&amp;P)</translation>
    </message>
    <message>
        <source>Select the previous node</source>
        <translation>选择上一个节点</translation>
    </message>
    <message>
        <source>Rotate &amp;Left 15°</source>
        <translation>左转 15°(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the selection anticlockwise</source>
        <translation>逆时针旋转所选对象</translation>
    </message>
    <message>
        <source>Rotate &amp;Right 15°</source>
        <translation>右转 15°(&amp;R)</translation>
    </message>
    <message>
        <source>Turn the selection clockwise</source>
        <translation>顺时针旋转所选对象</translation>
    </message>
    <message>
        <source>Rotate Left &amp;90°</source>
        <translation>左转 90°(&amp;9)</translation>
    </message>
    <message>
        <source>Turn the selection a quarter anticlockwise</source>
        <translation>逆时针旋转所选对象四分之一圈</translation>
    </message>
    <message>
        <source>Rotate Right 9&amp;0°</source>
        <translation>右转 90°(&amp;0)</translation>
    </message>
    <message>
        <source>Turn the selection a quarter clockwise</source>
        <translation>顺时针旋转所选对象四分之一圈</translation>
    </message>
    <message>
        <source>Flip &amp;Horizontally</source>
        <translation>水平翻转(&amp;H)</translation>
    </message>
    <message>
        <source>Swap left and right; walls stay solid on the same side</source>
        <translation>左右互换；墙的实心侧不变</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>垂直翻转(&amp;V)</translation>
    </message>
    <message>
        <source>Swap above and below; walls stay solid on the same side</source>
        <translation>上下互换；墙的实心侧不变</translation>
    </message>
    <message>
        <source>Re&amp;peat Last Transform</source>
        <translation>重复上次变换(&amp;P)</translation>
    </message>
    <message>
        <source>Move, turn, scale or copy the selection once more as it was done last</source>
        <translation>按上次的方式再次移动、旋转、缩放或复制所选对象</translation>
    </message>
    <message>
        <source>&amp;Type Place and Size…</source>
        <translation>输入位置和大小(&amp;T)…</translation>
    </message>
    <message>
        <source>Move, scale and turn the selection by numbers</source>
        <translation>用数值移动、缩放和旋转所选对象</translation>
    </message>
    <message>
        <source>L&amp;inear Array…</source>
        <translation>线性阵列(&amp;I)…</translation>
    </message>
    <message>
        <source>Make copies of the selection in a row</source>
        <translation>沿直线复制所选对象</translation>
    </message>
    <message>
        <source>R&amp;adial Array…</source>
        <translation>环形阵列(&amp;A)…</translation>
    </message>
    <message>
        <source>Make copies of the selection round its pivot</source>
        <translation>绕轴心复制所选对象</translation>
    </message>
    <message>
        <source>Re&amp;verse Direction</source>
        <translation>反转方向(&amp;V)</translation>
    </message>
    <message>
        <source>Make one-way walls solid from the other side</source>
        <translation>使单向墙改为另一侧实心</translation>
    </message>
    <message>
        <source>&amp;Bounding Boxes</source>
        <translation>包围盒(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Incircles</source>
        <translation>内切圆(&amp;I)</translation>
    </message>
    <message>
        <source>Show the incircle of every polygon</source>
        <translation>显示每个多边形的内切圆</translation>
    </message>
    <message>
        <source>&amp;Velocities</source>
        <translation>速度(&amp;V)</translation>
    </message>
    <message>
        <source>Show where every body would be in a second</source>
        <translation>显示每个物体一秒后的位置</translation>
    </message>
    <message>
        <source>&amp;Orientations</source>
        <translation>朝向(&amp;O)</translation>
    </message>
    <message>
        <source>Show which way up every body is</source>
        <translation>显示每个物体的朝向</translation>
    </message>
    <message>
        <source>&amp;Normals</source>
        <translation>法线(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;All Off</source>
        <translation>全部关闭(&amp;A)</translation>
    </message>
    <message>
        <source>Hide all overlays</source>
        <translation>隐藏所有叠加显示</translation>
    </message>
    <message>
        <source>&amp;Tags</source>
        <translation>标签(&amp;G)</translation>
    </message>
    <message>
        <source>Show names and colors of the tags of every object</source>
        <translation>显示每个对象的标签名称和颜色</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>问题(&amp;P)</translation>
    </message>
    <message>
        <source>Mark the places of all problems of the level</source>
        <translation>标出关卡中所有问题的位置</translation>
    </message>
    <message>
        <source>Sho&amp;w What Collides</source>
        <translation>显示碰撞对象(&amp;C)</translation>
    </message>
    <message>
        <source>Mark everything that the selection would collide with, by its tags</source>
        <translation>按标签标出所选对象会碰撞的一切</translation>
    </message>
    <message>
        <source>&amp;Find…</source>
        <translation>查找(&amp;F)…</translation>
    </message>
    <message>
        <source>Find objects by name, kind or tag in the outliner</source>
        <translation>在大纲视图中按名称、类型或标签查找对象</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>重命名(&amp;M)…</translation>
    </message>
    <message>
        <source>Give the selected object another name, in the outliner</source>
        <translation>在大纲视图中给所选对象改名</translation>
    </message>
    <message>
        <source>Level P&amp;roperties…</source>
        <translation>关卡属性(&amp;R)…</translation>
    </message>
    <message>
        <source>Edit the name, rules and physics of the level itself</source>
        <translation>编辑关卡本身的名称、规则和物理</translation>
    </message>
    <message>
        <source>Compare &amp;With…</source>
        <translation>比较(&amp;C)…</translation>
    </message>
    <message>
        <source>Choose a level file and show what is different from it</source>
        <translation>选择一个关卡文件，显示其中的差异</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>试玩(&amp;P)</translation>
    </message>
    <message>
        <source>Play a copy of the level, here and now</source>
        <translation>在此立即试玩关卡的副本</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>停止(&amp;S)</translation>
    </message>
    <message>
        <source>Pa&amp;use</source>
        <translation>暂停(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Next Frame</source>
        <translation>下一帧(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Restart</source>
        <translation>重新开始(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Snap to Grid</source>
        <translation>吸附到网格(&amp;S)</translation>
    </message>
    <message>
        <source>Let points land on the grid; Ctrl suspends it while it is held</source>
        <translation>让点落在网格上；按住 Ctrl 可暂停吸附</translation>
    </message>
    <message>
        <source>&amp;Coarser Grid</source>
        <translation>更粗网格(&amp;C)</translation>
    </message>
    <message>
        <source>Go on to the next larger step of the grid</source>
        <translation>切换到更大一级的网格步长</translation>
    </message>
    <message>
        <source>&amp;Finer Grid</source>
        <translation>更细网格(&amp;F)</translation>
    </message>
    <message>
        <source>Go on to the next smaller step of the grid</source>
        <translation>切换到更小一级的网格步长</translation>
    </message>
    <message>
        <source>Snap to &amp;Objects</source>
        <translation>吸附到对象(&amp;O)</translation>
    </message>
    <message>
        <source>Let points land on what is in the level; Ctrl suspends it while it is held</source>
        <translation>让点落在关卡的内容上；按住 Ctrl 可暂停吸附</translation>
    </message>
    <message>
        <source>&amp;Vertices and Centers</source>
        <translation>顶点和中心(&amp;V)</translation>
    </message>
    <message>
        <source>Snap to the vertices of objects, and to the centers of circles</source>
        <translation>吸附到对象的顶点和圆的中心</translation>
    </message>
    <message>
        <source>Only while snapping to objects is on.</source>
        <translation>仅在开启“吸附到对象”时可用。</translation>
    </message>
    <message>
        <source>&amp;Midpoints</source>
        <translation>中点(&amp;M)</translation>
    </message>
    <message>
        <source>Snap to the middles of segments</source>
        <translation>吸附到线段的中点</translation>
    </message>
    <message>
        <source>&amp;Intersections</source>
        <translation>交点(&amp;I)</translation>
    </message>
    <message>
        <source>Snap to where edges and guides cross</source>
        <translation>吸附到边与参考线的交点</translation>
    </message>
    <message>
        <source>&amp;Perpendiculars</source>
        <translation>垂足(&amp;P)</translation>
    </message>
    <message>
        <source>Snap to where the way from the last point meets an edge at a right angle</source>
        <translation>吸附到从上一点出发与边垂直相交之处</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>边(&amp;E)</translation>
    </message>
    <message>
        <source>Snap to the edges of objects</source>
        <translation>吸附到对象的边</translation>
    </message>
    <message>
        <source>G&amp;uides</source>
        <translation>参考线(&amp;U)</translation>
    </message>
    <message>
        <source>Snap to guides</source>
        <translation>吸附到参考线</translation>
    </message>
    <message>
        <source>&amp;Alignment</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>Snap in line with the sides and middles of other objects</source>
        <translation>与其他对象的边和中线对齐吸附</translation>
    </message>
    <message>
        <source>A&amp;ngles</source>
        <translation>角度(&amp;N)</translation>
    </message>
    <message>
        <source>Snap to multiples of 15° from the last point; Shift keeps to them always</source>
        <translation>吸附到以上一点为起点的 15° 倍数；Shift 可始终保持</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>选择(&amp;S)</translation>
    </message>
    <message>
        <source>Select and move objects</source>
        <translation>选择和移动对象</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>节点(&amp;N)</translation>
    </message>
    <message>
        <source>Move, insert and delete the nodes of selected objects</source>
        <translation>移动、插入和删除所选对象的节点</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>切刀(&amp;K)</translation>
    </message>
    <message>
        <source>Cut walls, lines and polygons along a line</source>
        <translation>沿一条线切割墙、线和多边形</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>测量(&amp;M)</translation>
    </message>
    <message>
        <source>Measure lengths and angles</source>
        <translation>测量长度和角度</translation>
    </message>
    <message>
        <source>One-Way &amp;Wall</source>
        <translation>单向墙(&amp;W)</translation>
    </message>
    <message>
        <source>Draw walls that are solid from one side</source>
        <translation>绘制仅一侧实心的墙</translation>
    </message>
    <message>
        <source>Two-Way &amp;Line</source>
        <translation>双向线(&amp;L)</translation>
    </message>
    <message>
        <source>Draw walls that are solid from both sides</source>
        <translation>绘制两侧都实心的墙</translation>
    </message>
    <message>
        <source>&amp;Polygon</source>
        <translation>多边形(&amp;P)</translation>
    </message>
    <message>
        <source>Draw a solid polygon</source>
        <translation>绘制实心多边形</translation>
    </message>
    <message>
        <source>&amp;Rectangle</source>
        <translation>矩形(&amp;R)</translation>
    </message>
    <message>
        <source>Draw a solid rectangle</source>
        <translation>绘制实心矩形</translation>
    </message>
    <message>
        <source>&amp;Circle</source>
        <translation>圆(&amp;C)</translation>
    </message>
    <message>
        <source>Draw a circle from its center</source>
        <translation>从中心绘制圆</translation>
    </message>
    <message>
        <source>Moving &amp;Body</source>
        <translation>运动物体(&amp;V)</translation>
    </message>
    <message>
        <source>Draw a body that moves as it is told, and its velocity</source>
        <translation>绘制按设定运动的物体及其速度</translation>
    </message>
    <message>
        <source>C&amp;onnector</source>
        <translation>连接件(&amp;O)</translation>
    </message>
    <message>
        <source>Join two bodies by a spring or rope</source>
        <translation>用弹簧或绳索连接两个物体</translation>
    </message>
    <message>
        <source>S&amp;hip</source>
        <translation>飞船(&amp;H)</translation>
    </message>
    <message>
        <source>Place the ship; drag to turn it</source>
        <translation>放置飞船；拖动可旋转</translation>
    </message>
    <message>
        <source>Pa&amp;yload</source>
        <translation>载荷(&amp;Y)</translation>
    </message>
    <message>
        <source>Place the payload</source>
        <translation>放置载荷</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>终点(&amp;F)</translation>
    </message>
    <message>
        <source>Draw the line that the payload has to cross</source>
        <translation>绘制载荷必须越过的线</translation>
    </message>
    <message>
        <source>Pl&amp;ace Ship, Payload, Finish</source>
        <translation>放置飞船、载荷、终点(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Guide…</source>
        <translation>参考线(&amp;G)…</translation>
    </message>
    <message>
        <source>Add a guide at the pointer and type where it is</source>
        <translation>在指针处添加参考线并输入其位置</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>放大(&amp;Z)</translation>
    </message>
    <message>
        <source>Show less of the level, larger</source>
        <translation>显示较小范围，图形更大</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>缩小(&amp;M)</translation>
    </message>
    <message>
        <source>Show more of the level, smaller</source>
        <translation>显示较大范围，图形更小</translation>
    </message>
    <message>
        <source>Original Si&amp;ze</source>
        <translation>原始大小(&amp;O)</translation>
    </message>
    <message>
        <source>Show the level as large as in the game</source>
        <translation>按游戏中的大小显示关卡</translation>
    </message>
    <message>
        <source>&amp;Fit Level</source>
        <translation>适应关卡(&amp;I)</translation>
    </message>
    <message>
        <source>Show the whole level</source>
        <translation>显示整个关卡</translation>
    </message>
    <message>
        <source>&amp;Center Selection</source>
        <translation>居中所选对象(&amp;E)</translation>
    </message>
    <message>
        <source>Bring the selection to the middle of the view</source>
        <translation>把所选对象移到视图中央</translation>
    </message>
    <message>
        <source>Fra&amp;me Selection</source>
        <translation>缩放到所选对象(&amp;S)</translation>
    </message>
    <message>
        <source>Show the selection as large as fits</source>
        <translation>尽可能大地显示所选对象</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>网格(&amp;R)</translation>
    </message>
    <message>
        <source>Show the grid</source>
        <translation>显示网格</translation>
    </message>
    <message>
        <source>&amp;Rulers</source>
        <translation>标尺(&amp;U)</translation>
    </message>
    <message>
        <source>Show the rulers, out of which guides are dragged</source>
        <translation>显示标尺，可从中拖出参考线</translation>
    </message>
    <message>
        <source>Guid&amp;es</source>
        <translation>参考线(&amp;D)</translation>
    </message>
    <message>
        <source>Show the guides; what is hidden is neither taken nor snapped to</source>
        <translation>显示参考线；隐藏时既不能拾取也不能吸附</translation>
    </message>
    <message>
        <source>&amp;Delete All Guides</source>
        <translation>删除所有参考线(&amp;L)</translation>
    </message>
    <message>
        <source>Take all guides out of the level</source>
        <translation>从关卡中移除所有参考线</translation>
    </message>
    <message>
        <source>The level has no guides.</source>
        <translation>关卡没有参考线。</translation>
    </message>
    <message>
        <source>Hide &amp;All</source>
        <translation>全部隐藏(&amp;I)</translation>
    </message>
    <message>
        <source>Put all panels out of the way, and back as they were</source>
        <translation>收起所有面板，再按一次恢复</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>全屏(&amp;F)</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>使用整个屏幕</translation>
    </message>
    <message>
        <source>Like &amp;the Desktop</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
    <message>
        <source>Light or dark as the desktop is, and changing with it</source>
        <translation>明暗随桌面设置变化</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>Light panels and a white drawing board</source>
        <translation>浅色面板，白色画布</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;A)</translation>
    </message>
    <message>
        <source>Dark panels and a drawing board as dark as space</source>
        <translation>深色面板，如太空般漆黑的画布</translation>
    </message>
    <message>
        <source>New &amp;Window</source>
        <translation>新建窗口(&amp;W)</translation>
    </message>
    <message>
        <source>Start an empty level in another window</source>
        <translation>在另一个窗口中新建空关卡</translation>
    </message>
    <message>
        <source>New &amp;View</source>
        <translation>新建视图(&amp;V)</translation>
    </message>
    <message>
        <source>Show this level in a second window, at another place or another size</source>
        <translation>在第二个窗口中以其他位置或大小显示此关卡</translation>
    </message>
    <message>
        <source>&amp;Next Window</source>
        <translation>下一个窗口(&amp;N)</translation>
    </message>
    <message>
        <source>Go on in the next window of the program</source>
        <translation>转到程序的下一个窗口</translation>
    </message>
    <message>
        <source>Welcome &amp;Page</source>
        <translation>欢迎页(&amp;P)</translation>
    </message>
    <message>
        <source>Choose among recent levels and those that come with the program</source>
        <translation>从最近的关卡和程序自带的关卡中选择</translation>
    </message>
    <message>
        <source>&amp;Reopen Windows at Start</source>
        <translation>启动时重新打开窗口(&amp;R)</translation>
    </message>
    <message>
        <source>Begin with the levels that were open when the program was left</source>
        <translation>启动时打开上次退出时打开的关卡</translation>
    </message>
    <message>
        <source>Open a level first.</source>
        <translation>请先打开一个关卡。</translation>
    </message>
    <message>
        <source>No level has been closed yet.</source>
        <translation>尚未关闭过任何关卡。</translation>
    </message>
    <message>
        <source>The level has no file yet.</source>
        <translation>此关卡还没有文件。</translation>
    </message>
    <message>
        <source>Go to a problem first for which there is a fix.</source>
        <translation>请先转到一个可以修复的问题。</translation>
    </message>
    <message>
        <source>There is no problem that could be cured without asking.</source>
        <translation>没有可以直接修复的问题。</translation>
    </message>
    <message>
        <source>Go to a problem first.</source>
        <translation>请先转到一个问题。</translation>
    </message>
    <message>
        <source>The grid is as coarse as it gets.</source>
        <translation>网格已经最粗。</translation>
    </message>
    <message>
        <source>The grid is as fine as it gets.</source>
        <translation>网格已经最细。</translation>
    </message>
    <message>
        <source>This window stands alone.</source>
        <translation>此窗口是独立的。</translation>
    </message>
    <message>
        <source>There is no other window.</source>
        <translation>没有其他窗口。</translation>
    </message>
    <message>
        <source>Show the bounding box of every body, and that of the broad phase</source>
        <translation>显示每个物体的包围盒及其粗测阶段包围盒</translation>
    </message>
    <message>
        <source>Show the free side of every wall, and the solid band behind it</source>
        <translation>显示每面墙的自由侧及其后的实心带</translation>
    </message>
    <message>
        <source>&amp;Quadtrees</source>
        <translation>四叉树(&amp;Q)</translation>
    </message>
    <message>
        <source>Show the cells in which collisions are looked for, and what they hold</source>
        <translation>显示用于查找碰撞的单元及其内容</translation>
    </message>
    <message>
        <source>&amp;Contacts</source>
        <translation>接触(&amp;T)</translation>
    </message>
    <message>
        <source>Show where bodies touch, and the forces between them</source>
        <translation>显示物体的接触位置以及它们之间的力</translation>
    </message>
    <message>
        <source>T&amp;ension</source>
        <translation>张力(&amp;E)</translation>
    </message>
    <message>
        <source>Show how much every rope and connector pulls</source>
        <translation>显示每根绳索和每个连接件的拉力</translation>
    </message>
    <message>
        <source>T&amp;rails</source>
        <translation>轨迹(&amp;R)</translation>
    </message>
    <message>
        <source>Show the way that every body has gone, or will go at first</source>
        <translation>显示每个物体走过的或起初将走的路径</translation>
    </message>
    <message>
        <source>Centers of &amp;Mass</source>
        <translation>质心(&amp;M)</translation>
    </message>
    <message>
        <source>Show the center of mass of every body</source>
        <translation>显示每个物体的质心</translation>
    </message>
    <message>
        <source>Names</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Show the name of every object that has one</source>
        <translation>显示每个已命名对象的名称</translation>
    </message>
    <message>
        <source>I&amp;slands and Sleep</source>
        <translation>孤岛与休眠(&amp;D)</translation>
    </message>
    <message>
        <source>Show which bodies may push each other, and which ones sleep</source>
        <translation>显示哪些物体可能互相推动，哪些正在休眠</translation>
    </message>
    <message>
        <source>Ris&amp;k of Passing Through</source>
        <translation>穿透风险(&amp;S)</translation>
    </message>
    <message>
        <source>Show how far through each wall one iteration may carry what approaches it</source>
        <translation>显示接近每面墙的物体在一次迭代中可能穿入多深</translation>
    </message>
    <message>
        <source>Reach o&amp;f the Ship</source>
        <translation>飞船可达范围(&amp;H)</translation>
    </message>
    <message>
        <source>Show where the ship, and the payload on its rope, can be in the next seconds: from its start, or from where it is in a run that is paused</source>
        <translation>显示飞船及其绳索上的载荷在接下来几秒内可能到达的位置：从起点算起，或在已暂停的运行中从当前位置算起</translation>
    </message>
    <message>
        <source>Reach a Second Longer</source>
        <translation>可达范围延长一秒</translation>
    </message>
    <message>
        <source>Look a second further ahead, up to five</source>
        <translation>多预测一秒，最多五秒</translation>
    </message>
    <message>
        <source>Reach a Second Shorter</source>
        <translation>可达范围缩短一秒</translation>
    </message>
    <message>
        <source>Look less far ahead, down to one second</source>
        <translation>缩短预测时间，最少一秒</translation>
    </message>
    <message>
        <source>&amp;Legend</source>
        <translation>图例(&amp;L)</translation>
    </message>
    <message>
        <source>Explain the colors of the overlays that are on, in a corner of the canvas</source>
        <translation>在画布一角说明已开启的叠加显示的颜色</translation>
    </message>
    <message>
        <source>Color-Blind-Safe Colors</source>
        <translation>色盲友好颜色</translation>
    </message>
    <message>
        <source>Draw the overlays in the colors of Okabe and Ito, which everybody tells apart</source>
        <translation>用人人都能区分的 Okabe-Ito 配色绘制叠加显示</translation>
    </message>
    <message>
        <source>Forget Own Colors</source>
        <translation>清除自定颜色</translation>
    </message>
    <message>
        <source>Give all overlays the colors of the set again</source>
        <translation>让所有叠加显示恢复为配色方案的颜色</translation>
    </message>
    <message>
        <source>No overlay has a color of your own: click one in the legend.</source>
        <translation>没有叠加显示使用自定颜色：请单击图例中的一项。</translation>
    </message>
    <message>
        <source>S&amp;imulate</source>
        <translation>模拟(&amp;I)</translation>
    </message>
    <message>
        <source>Let the bodies of the level move in place, and go on editing beside</source>
        <translation>让关卡中的物体就地运动，同时可继续编辑</translation>
    </message>
    <message>
        <source>The level runs already.</source>
        <translation>关卡已在运行。</translation>
    </message>
    <message>
        <source>Play fr&amp;om Pointer</source>
        <translation>从指针处试玩(&amp;O)</translation>
    </message>
    <message>
        <source>Play a copy of the level in which the ship starts where the pointer is</source>
        <translation>试玩关卡的副本，飞船从指针处出发</translation>
    </message>
    <message>
        <source>Go back to the drawing board</source>
        <translation>返回画布</translation>
    </message>
    <message>
        <source>Hold what runs, or let it go on</source>
        <translation>暂停或继续运行</translation>
    </message>
    <message>
        <source>Hold what runs and advance it by one update</source>
        <translation>暂停运行并前进一个时间步</translation>
    </message>
    <message>
        <source>Run the level from its beginning</source>
        <translation>从头运行关卡</translation>
    </message>
    <message>
        <source>Pre&amp;vious Frame</source>
        <translation>上一帧(&amp;V)</translation>
    </message>
    <message>
        <source>Hold what runs and go back by one update</source>
        <translation>暂停运行并后退一个时间步</translation>
    </message>
    <message>
        <source>Next I&amp;teration</source>
        <translation>下一次迭代(&amp;T)</translation>
    </message>
    <message>
        <source>Hold what runs and look into the next update, one iteration further</source>
        <translation>暂停运行并查看下一时间步的内部，每次前进一次迭代</translation>
    </message>
    <message>
        <source>To the &amp;Beginning</source>
        <translation>到开头(&amp;B)</translation>
    </message>
    <message>
        <source>Hold what runs and go back as far as it is kept</source>
        <translation>暂停运行并回到所保留的最早时刻</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>到结尾(&amp;E)</translation>
    </message>
    <message>
        <source>Hold what runs and show its last moment</source>
        <translation>暂停运行并显示其最后时刻</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>减慢(&amp;L)</translation>
    </message>
    <message>
        <source>Let time run half as fast; [ does so on the canvas</source>
        <translation>让时间流速减半；在画布上可按 [</translation>
    </message>
    <message>
        <source>F&amp;aster</source>
        <translation>加快(&amp;A)</translation>
    </message>
    <message>
        <source>Let time run twice as fast; ] does so on the canvas</source>
        <translation>让时间流速加倍；在画布上可按 ]</translation>
    </message>
    <message>
        <source>&amp;Follow the Ship</source>
        <translation>跟随飞船(&amp;F)</translation>
    </message>
    <message>
        <source>Let the view go with the ship again, after it has been moved</source>
        <translation>移动视图后，让其重新跟随飞船</translation>
    </message>
    <message>
        <source>Only in a game is there a ship to follow.</source>
        <translation>只有在游戏中才有可跟随的飞船。</translation>
    </message>
    <message>
        <source>Save Fli&amp;ght…</source>
        <translation>保存飞行记录(&amp;G)…</translation>
    </message>
    <message>
        <source>Write what has been flown into a file that can be dropped on a window</source>
        <translation>把已飞行的过程写入可拖放到窗口上的文件</translation>
    </message>
    <message>
        <source>Copy &amp;Bug Capsule</source>
        <translation>复制错误胶囊(&amp;B)</translation>
    </message>
    <message>
        <source>Copy the level and the run up to this moment as text, for a mail or an issue; pasted into a window, it opens at the same moment</source>
        <translation>将关卡和到此刻为止的运行复制为文本，可用于邮件或问题报告；粘贴到窗口中后会在同一时刻打开</translation>
    </message>
    <message>
        <source>In a game only while its panels are shown.</source>
        <translation>在游戏中仅当显示面板时可用。</translation>
    </message>
    <message>
        <source>Overlay Colors…</source>
        <translation>叠加层颜色…</translation>
    </message>
    <message>
        <source>Choose the set of colors of the overlays, and colors of your own for each</source>
        <translation>选择叠加层的配色方案，并为每个叠加层选择自己的颜色</translation>
    </message>
    <message>
        <source>Wa&amp;ys of a Run</source>
        <translation>运行轨迹(&amp;Y)</translation>
    </message>
    <message>
        <source>Show the ways of the last minute where a run is held, and those of futures given up</source>
        <translation>暂停时显示最近一分钟的轨迹和已放弃的未来轨迹</translation>
    </message>
    <message>
        <source>What is selected is locked.</source>
        <translation>所选对象已锁定。</translation>
    </message>
    <message>
        <source>Ship, payload and finish exist once, and connectors are copied with their two bodies.</source>
        <translation>飞船、载荷和终点只有一个；连接件须与其两个物体一起复制。</translation>
    </message>
    <message>
        <source>Select a wall or a line first.</source>
        <translation>请先选择墙或线。</translation>
    </message>
    <message>
        <source>Select a group first.</source>
        <translation>请先选择一个组。</translation>
    </message>
    <message>
        <source>What is selected has no nodes.</source>
        <translation>所选对象没有节点。</translation>
    </message>
    <message>
        <source>“%1” changes nothing here.</source>
        <translation>“%1”在此不会改变任何内容。</translation>
    </message>
    <message>
        <source>Put the selection into a new layer, or make an empty one, and type its name</source>
        <translation>将所选对象放入新图层或新建空图层，并输入名称</translation>
    </message>
    <message>
        <source>Insert Node &amp;Here</source>
        <translation>在此插入节点(&amp;H)</translation>
    </message>
    <message>
        <source>Insert a node where the pointer is at an edge of the selection</source>
        <translation>在指针所在的所选对象边上插入节点</translation>
    </message>
    <message>
        <source>Not while the level runs.</source>
        <translation>关卡运行时不可用。</translation>
    </message>
    <message>
        <source>Place ship, payload or finish, first what the level lacks; again for the next of them</source>
        <translation>放置飞船、载荷或终点，先放关卡缺少的；再按一次切换到下一个</translation>
    </message>
</context>
<context>
    <name>BugCapsule</name>
    <message>
        <source>Another bug capsule is still being worked on.</source>
        <translation>另一个错误胶囊仍在处理中。</translation>
    </message>
    <message>
        <source>A bug capsule of %1 is on the clipboard. Paste it into a mail or an issue, or into a window of this program.</source>
        <translation>%1 的错误胶囊已在剪贴板中。请将其粘贴到邮件、问题报告或本程序的窗口中。</translation>
    </message>
    <message>
        <source>The run comes out otherwise here than where the bug capsule was made, with %1 on %2.</source>
        <translation>此处的运行结果与创建错误胶囊时（%2 上的 %1）不同。</translation>
    </message>
    <message>
        <source>The bug capsule is being read…</source>
        <translation>正在读取错误胶囊…</translation>
    </message>
    <message>
        <source>The bug capsule</source>
        <translation>错误胶囊</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>… and %1 more</source>
        <translation>… 还有 %1 项</translation>
    </message>
</context>
<context>
    <name>Compared</name>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>all but %1</source>
        <translation>除 %1 外全部</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>“%1”</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>是</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Level: %1</source>
        <translation>关卡：%1</translation>
    </message>
    <message>
        <source>Guide %1: added</source>
        <translation>参考线 %1：已添加</translation>
    </message>
    <message>
        <source>Guide %1: removed</source>
        <translation>参考线 %1：已移除</translation>
    </message>
    <message>
        <source>Level: fields that this program does not know</source>
        <translation>关卡：本程序不认识的字段</translation>
    </message>
    <message>
        <source>Level: other problems are hidden</source>
        <translation>关卡：隐藏的问题不同</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Tag “%1”: added</source>
        <translation>标签“%1”：已添加</translation>
    </message>
    <message>
        <source>Tag “%1”: removed</source>
        <translation>标签“%1”：已移除</translation>
    </message>
    <message>
        <source>Tag “%1”: renamed to “%2”</source>
        <translation>标签“%1”：已重命名为“%2”</translation>
    </message>
    <message>
        <source>Tag “%1”: color %2 → %3</source>
        <translation>标签“%1”：颜色 %2 → %3</translation>
    </message>
    <message>
        <source>added</source>
        <translation>已添加</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>已移除</translation>
    </message>
    <message>
        <source>was %1</source>
        <translation>原为 %1</translation>
    </message>
    <message>
        <source>shape moved</source>
        <translation>形状已移动</translation>
    </message>
    <message>
        <source>shape changed</source>
        <translation>形状已更改</translation>
    </message>
    <message>
        <source>shape changed, points %1 → %2</source>
        <translation>形状已更改，点数 %1 → %2</translation>
    </message>
    <message>
        <source>drawn in another place</source>
        <translation>绘制次序不同</translation>
    </message>
    <message>
        <source>fields that this program does not know</source>
        <translation>本程序不认识的字段</translation>
    </message>
    <message>
        <source>The level</source>
        <translation>关卡</translation>
    </message>
    <message>
        <source>%1: both sides changed “%2”.</source>
        <translation>%1：双方都更改了“%2”。</translation>
    </message>
    <message>
        <source>%1: both sides made something else of it.</source>
        <translation>%1：双方把它改成了不同的东西。</translation>
    </message>
    <message>
        <source>%1: both sides added another object under the key %2.</source>
        <translation>%1：双方以标识 %2 添加了不同的对象。</translation>
    </message>
    <message>
        <source>%1: our side removed it, their side changed or needs it. It stays.</source>
        <translation>%1：我方已移除，对方更改了它或需要它。予以保留。</translation>
    </message>
    <message>
        <source>%1: their side removed it, our side changed or needs it. It stays.</source>
        <translation>%1：对方已移除，我方更改了它或需要它。予以保留。</translation>
    </message>
    <message>
        <source>%1: groups would be in each other. It stays in the group that our side has put it in.</source>
        <translation>%1：组会互相包含。它留在我方所放的组中。</translation>
    </message>
    <message>
        <source>%1: both sides changed the order of drawing.</source>
        <translation>%1：双方都更改了绘制次序。</translation>
    </message>
    <message>
        <source>There is no room for the tag “%1” of their side among the 32 tags.</source>
        <translation>32 个标签中没有空位可容纳对方的标签“%1”。</translation>
    </message>
    <message>
        <source>Guides: in another order</source>
        <translation>参考线：次序不同</translation>
    </message>
    <message>
        <source>at %1; %2</source>
        <translation>位于 %1; %2</translation>
    </message>
</context>
<context>
    <name>CrashWords</name>
    <message>
        <source>The ship hit the payload.</source>
        <translation>飞船撞上了货物。</translation>
    </message>
    <message>
        <source>The ship hit “%1”.</source>
        <translation>飞船撞上了“%1”。</translation>
    </message>
    <message>
        <source>The payload hit “%1”.</source>
        <translation>货物撞上了“%1”。</translation>
    </message>
    <message>
        <source>The ship hit something tagged “%1”.</source>
        <translation>飞船撞上了带有标签“%1”的物体。</translation>
    </message>
    <message>
        <source>The payload hit something tagged “%1”.</source>
        <translation>货物撞上了带有标签“%1”的物体。</translation>
    </message>
</context>
<context>
    <name>DroppedFiles</name>
    <message>
        <source>%1 is a flight in the level “%2”, which is neither open nor beside it. Open the level and drop the flight on it.</source>
        <translation>%1 是关卡“%2”的飞行记录，该关卡既未打开，也不在同一文件夹。请打开该关卡，再把飞行记录拖放到上面。</translation>
    </message>
    <message>
        <source>The level has been changed since the flight was recorded, which may therefore end otherwise.</source>
        <translation>录制飞行之后关卡已被更改，因此结果可能不同。</translation>
    </message>
    <message>
        <source>Files of other programs are imported one at a time, as each is looked at first: of these it is %1.</source>
        <translation>其他程序的文件逐个导入，因为每个都要先查看：此次导入的是 %1。</translation>
    </message>
    <message>
        <source>There is not enough memory to read the flight.</source>
        <translation>内存不足，无法读取飞行记录。</translation>
    </message>
    <message>
        <source>%1 is a simulation of the level “%2”, which is neither open nor beside it. Open the level and drop the simulation on it.</source>
        <translation>%1 是关卡“%2”的模拟，该关卡既未打开也不在其旁边。请打开关卡并将模拟拖放到其上。</translation>
    </message>
    <message>
        <source>The level has been changed since the simulation was recorded, which may therefore go otherwise.</source>
        <translation>录制模拟后关卡已更改，因此模拟过程可能不同。</translation>
    </message>
</context>
<context>
    <name>Explain</name>
    <message>
        <source>Debris</source>
        <translation>碎片</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>Thrust and steering</source>
        <translation>推力和转向</translation>
    </message>
    <message>
        <source>Pulled by the mouse</source>
        <translation>鼠标拖拽</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>合计</translation>
    </message>
    <message>
        <source>felt, without a force</source>
        <translation>有感应，无作用力</translation>
    </message>
    <message>
        <source>%1, of which friction %2</source>
        <translation>%1，其中摩擦 %2</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Tags touched</source>
        <translation>接触的标签</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Turns</source>
        <translation>转动</translation>
    </message>
    <message>
        <source>Kinetic energy</source>
        <translation>动能</translation>
    </message>
    <message>
        <source>Potential energy</source>
        <translation>势能</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>动量</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>自旋角动量</translation>
    </message>
    <message>
        <source>Angular momentum</source>
        <translation>角动量</translation>
    </message>
    <message>
        <source>Sleeps</source>
        <translation>休眠中</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>拉力</translation>
    </message>
    <message>
        <source>Distance of its ends</source>
        <translation>两端距离</translation>
    </message>
    <message>
        <source>Natural length</source>
        <translation>自然长度</translation>
    </message>
    <message>
        <source>Pushes with</source>
        <translation>推力大小</translation>
    </message>
    <message>
        <source>Pulls with</source>
        <translation>拉力大小</translation>
    </message>
    <message>
        <source>Elastic energy</source>
        <translation>弹性势能</translation>
    </message>
    <message>
        <source>Between</source>
        <translation>两端物体</translation>
    </message>
    <message>
        <source>All bodies</source>
        <translation>所有物体</translation>
    </message>
    <message>
        <source>Total energy</source>
        <translation>总能量</translation>
    </message>
</context>
<context>
    <name>FileReader</name>
    <message>
        <source>There is not enough memory to open the file.</source>
        <translation>内存不足，无法打开文件。</translation>
    </message>
    <message>
        <source>%1 is being read…</source>
        <translation>正在读取 %1…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>SpaceTow levels (*.json);;All files (*)</source>
        <translation>SpaceTow 关卡 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>未保存的更改</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>是否保存对“%1”的更改？</translation>
    </message>
    <message>
        <source>If you discard them, they are lost.</source>
        <translation>如果放弃，更改将丢失。</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>放弃(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>取消(&amp;C)</translation>
    </message>
    <message>
        <source>The example</source>
        <translation>示例</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… 还有 %1 项</translation>
    </message>
    <message>
        <source>Open level</source>
        <translation>打开关卡</translation>
    </message>
    <message>
        <source>Save level as</source>
        <translation>关卡另存为</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>未命名</translation>
    </message>
    <message>
        <source>level</source>
        <translation>关卡</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>%1 was opened, but:</source>
        <translation>已打开 %1，但是：</translation>
    </message>
    <message>
        <source>Nothing is lost: your work is still here. Save it elsewhere?</source>
        <translation>没有丢失任何内容：您的工作仍在这里。要保存到别处吗？</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>What was kept of %1 cannot be read.</source>
        <translation>无法读取为 %1 保留的内容。</translation>
    </message>
    <message>
        <source>Open Newest Backup</source>
        <translation>打开最新备份</translation>
    </message>
    <message>
        <source>This is the newest backup of %1. The file stays as it is until you save.</source>
        <translation>这是 %1 的最新备份。在您保存之前，文件保持不变。</translation>
    </message>
    <message>
        <source>This backup cannot be opened.</source>
        <translation>无法打开此备份。</translation>
    </message>
    <message>
        <source>%1 is saved, but of the version before no backup could be made:</source>
        <translation>%1 已保存，但无法为之前的版本创建备份：</translation>
    </message>
    <message>
        <source>Compare with level</source>
        <translation>与关卡比较</translation>
    </message>
</context>
<context>
    <name>FlightFile</name>
    <message>
        <source>The flight has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>飞行记录已保存为 %1。把该文件拖放到窗口上即可重新观看。</translation>
    </message>
    <message>
        <source>The simulation has been saved as %1. Drop the file on a window to see it again.</source>
        <translation>模拟已保存为 %1。把该文件拖放到窗口上即可重新观看。</translation>
    </message>
    <message>
        <source>It ends after %1 of %2 updates: a file holds no more.</source>
        <translation>在 %2 次更新中的第 %1 次后结束：文件容纳不下更多。</translation>
    </message>
    <message>
        <source>Another recording is still being saved.</source>
        <translation>另一段录制仍在保存。</translation>
    </message>
</context>
<context>
    <name>FlightsPanel</name>
    <message>
        <source>wins after %1 s, with %2 s of thrust</source>
        <translation>%1 s 后获胜，推进 %2 s</translation>
    </message>
    <message>
        <source>is being flown…</source>
        <translation>正在飞行…</translation>
    </message>
    <message>
        <source>still wins, after %1 s</source>
        <translation>仍然获胜，用时 %1 秒</translation>
    </message>
    <message>
        <source>still wins, now after %1 s; before after %2 s</source>
        <translation>仍然获胜，现在用时 %1 秒；之前为 %2 秒</translation>
    </message>
    <message>
        <source>crashed before, wins now after %1 s</source>
        <translation>之前坠毁，现在用时 %1 秒获胜</translation>
    </message>
    <message>
        <source>was not won before, wins now after %1 s</source>
        <translation>之前未获胜，现在用时 %1 秒获胜</translation>
    </message>
    <message>
        <source>still crashes at %1, after %2 s</source>
        <translation>仍在 %1 处坠毁，%2 秒后</translation>
    </message>
    <message>
        <source>still crashes, now at %1, after %2 s; before after %3 s</source>
        <translation>仍然坠毁，现在在 %1 处，%2 秒后；之前为 %3 秒后</translation>
    </message>
    <message>
        <source>won before, crashes now at %1, after %2 s</source>
        <translation>之前获胜，现在在 %1 处坠毁，%2 秒后</translation>
    </message>
    <message>
        <source>crashes now, at %1, after %2 s</source>
        <translation>现在坠毁，在 %1 处，%2 秒后</translation>
    </message>
    <message>
        <source>crashes at %1, after %2 s</source>
        <translation>在 %1 处坠毁，%2 秒后</translation>
    </message>
    <message>
        <source>won before, now there is no ship</source>
        <translation>之前获胜，现在没有飞船</translation>
    </message>
    <message>
        <source>runs to its end</source>
        <translation>运行至结束</translation>
    </message>
    <message>
        <source>is still under way at its end, at %1</source>
        <translation>结束时仍在途中，位于 %1</translation>
    </message>
    <message>
        <source>is still under way at its end, now at %1</source>
        <translation>结束时仍在途中，现在位于 %1</translation>
    </message>
    <message>
        <source>won before, now is under way at its end, at %1</source>
        <translation>之前获胜，现在结束时仍在途中，位于 %1</translation>
    </message>
    <message>
        <source>crashed before, now is under way at its end, at %1</source>
        <translation>之前坠毁，现在结束时仍在途中，位于 %1</translation>
    </message>
    <message>
        <source>is under way at its end, at %1</source>
        <translation>结束时在途中，位于 %1</translation>
    </message>
    <message>
        <source>cannot be flown: too many bodies lie in the same place. Move them apart.</source>
        <translation>无法飞行：同一位置的物体过多。请将它们移开。</translation>
    </message>
    <message>
        <source>is a simulation of %1 s</source>
        <translation>是一段 %1 秒的模拟</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>无法读取：%1</translation>
    </message>
</context>
<context>
    <name>Forces</name>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>Applied</source>
        <translation>施加的力</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
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
        <translation>就绪</translation>
    </message>
    <message>
        <source>Press a direction to start</source>
        <translation>按方向键开始</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>已坠毁</translation>
    </message>
    <message>
        <source>Press any key to try again</source>
        <translation>按任意键重试</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>游戏结束</translation>
    </message>
    <message>
        <source>No life is left. Press any key to start the level over</source>
        <translation>生命已用尽。按任意键重新开始关卡</translation>
    </message>
    <message>
        <source>You made it!</source>
        <translation>成功了！</translation>
    </message>
    <message>
        <source>Lives %1</source>
        <translation>生命 %1</translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation>时间 %1</translation>
    </message>
    <message>
        <source>Fuel used %1 s</source>
        <translation>已用燃料 %1 s</translation>
    </message>
    <message>
        <source>Gravity is upside down!</source>
        <translation>重力已颠倒！</translation>
    </message>
    <message>
        <source>menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a key and what it does</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The payload is home.</source>
        <translation>货物已送达。</translation>
    </message>
    <message>
        <source>fly again</source>
        <translation>再飞一次</translation>
    </message>
    <message>
        <source>go on</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>one step</source>
        <translation>单步</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>tow</source>
        <translation>拖曳</translation>
    </message>
    <message>
        <source>In range.</source>
        <translation>在范围内。</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>转向</translation>
    </message>
    <message>
        <source>thrust</source>
        <translation>推进</translation>
    </message>
    <message>
        <source>Take the payload in tow and carry it across the finish.</source>
        <translation>拖曳货物并将其带过终点线。</translation>
    </message>
    <message>
        <source>Ship and payload are lost.</source>
        <translation>飞船和货物都已损失。</translation>
    </message>
    <message>
        <source>The ship is lost.</source>
        <translation>飞船已损失。</translation>
    </message>
    <message>
        <source>The payload is lost.</source>
        <translation>货物已损失。</translation>
    </message>
</context>
<context>
    <name>Inspector</name>
    <message>
        <source>Static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>Kinematic</source>
        <translation>运动学</translation>
    </message>
    <message>
        <source>Dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>No tension</source>
        <translation>无张力</translation>
    </message>
    <message>
        <source>Unlimited</source>
        <translation>不限</translation>
    </message>
    <message>
        <source>Cut off</source>
        <translation>截断</translation>
    </message>
    <message>
        <source>Tanh</source>
        <translation>Tanh</translation>
    </message>
    <message>
        <source>Partial tanh</source>
        <translation>部分 Tanh</translation>
    </message>
    <message>
        <source>General</source>
        <translation>常规</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Matter</source>
        <translation>材质</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>碰撞</translation>
    </message>
    <message>
        <source>Rules of the game</source>
        <translation>游戏规则</translation>
    </message>
    <message>
        <source>Physics</source>
        <translation>物理</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>For people; several objects may share one</source>
        <translation>供人识别；多个对象可以同名</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Static bodies never move, kinematic ones move as told and are pushed by nothing, dynamic ones obey forces</source>
        <translation>静态物体从不移动；运动学物体按设定移动，不受推动；动态物体受力的作用</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Name or key of the group that it is in; nothing for none</source>
        <translation>所在组的名称或标识；留空表示无</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Of the group&apos;s mark and of what is selected in it</source>
        <translation>组标记及组内所选对象的颜色</translation>
    </message>
    <message>
        <source>Layer: a group at the top</source>
        <translation>图层：位于顶层的组</translation>
    </message>
    <message>
        <source>Visible in the editor</source>
        <translation>在编辑器中可见</translation>
    </message>
    <message>
        <source>Locked: cannot be picked or moved</source>
        <translation>已锁定：不能拾取或移动</translation>
    </message>
    <message>
        <source>Where the origin of the object is</source>
        <translation>对象原点的位置</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Anticlockwise. Plain numbers are degrees; write “rad” after radians</source>
        <translation>逆时针。纯数字为度；弧度后请写“rad”</translation>
    </message>
    <message>
        <source>From</source>
        <translation>从</translation>
    </message>
    <message>
        <source>One end of the finish</source>
        <translation>终点线的一端</translation>
    </message>
    <message>
        <source>To</source>
        <translation>到</translation>
    </message>
    <message>
        <source>The other end of the finish</source>
        <translation>终点线的另一端</translation>
    </message>
    <message>
        <source>Center</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>Middle of the circle in the coordinates of its body</source>
        <translation>圆心，采用其物体的坐标</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>From the middle to the rim</source>
        <translation>从圆心到边缘</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>How many corners the shape has; move them on the canvas</source>
        <translation>形状的角点数；可在画布上移动</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深度</translation>
    </message>
    <message>
        <source>How far behind the line counts as inside the wall; nothing for a wall without a back</source>
        <translation>线后多远仍算墙内；留空表示墙没有背面</translation>
    </message>
    <message>
        <source>no back</source>
        <translation>无背面</translation>
    </message>
    <message>
        <source>Closed: the last point joins the first</source>
        <translation>闭合：末点连接首点</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Nothing: area times density</source>
        <translation>留空：面积乘以密度</translation>
    </message>
    <message>
        <source>from shape</source>
        <translation>由形状得出</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>密度</translation>
    </message>
    <message>
        <source>Counts while no mass is given; a metre of wall weighs 1 kg times the density</source>
        <translation>未指定质量时有效；每米墙重 1 kg 乘以密度</translation>
    </message>
    <message>
        <source>Restitution</source>
        <translation>恢复系数</translation>
    </message>
    <message>
        <source>Share of the speed that is left after a bounce</source>
        <translation>反弹后剩余速度的比例</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Coefficient of friction: force along a surface per force on it</source>
        <translation>摩擦系数：沿表面的力与压力之比</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Of the center of mass at the start</source>
        <translation>质心的初始速度</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>Turning at the start, anticlockwise</source>
        <translation>初始转动，逆时针</translation>
    </message>
    <message>
        <source>Linear damping</source>
        <translation>线性阻尼</translation>
    </message>
    <message>
        <source>Share of the velocity that is lost each second</source>
        <translation>每秒损失的速度比例</translation>
    </message>
    <message>
        <source>Angular damping</source>
        <translation>角阻尼</translation>
    </message>
    <message>
        <source>Share of the spin that is lost each second</source>
        <translation>每秒损失的角速度比例</translation>
    </message>
    <message>
        <source>Frozen: held in place</source>
        <translation>冻结：固定不动</translation>
    </message>
    <message>
        <source>First body</source>
        <translation>第一物体</translation>
    </message>
    <message>
        <source>Name or key of the body that it holds</source>
        <translation>所连第一物体的名称或标识</translation>
    </message>
    <message>
        <source>Second body</source>
        <translation>第二物体</translation>
    </message>
    <message>
        <source>Name or key of the other body that it holds</source>
        <translation>所连另一物体的名称或标识</translation>
    </message>
    <message>
        <source>Anchor on first</source>
        <translation>第一锚点</translation>
    </message>
    <message>
        <source>Where it holds the first body, in the coordinates of that</source>
        <translation>在第一物体上的连接点，采用该物体的坐标</translation>
    </message>
    <message>
        <source>Anchor on second</source>
        <translation>第二锚点</translation>
    </message>
    <message>
        <source>Where it holds the second body, in the coordinates of that</source>
        <translation>在第二物体上的连接点，采用该物体的坐标</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>At which it neither pulls nor pushes; nothing: the distance at the start</source>
        <translation>不拉不推时的长度；留空：初始距离</translation>
    </message>
    <message>
        <source>as placed</source>
        <translation>按放置</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>刚度</translation>
    </message>
    <message>
        <source>Force per metre of stretch</source>
        <translation>每米伸长的力</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>阻尼</translation>
    </message>
    <message>
        <source>Force against the speed of stretching</source>
        <translation>抵抗伸长速度的力</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>How the force of the spring is limited</source>
        <translation>弹簧力的限制方式</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Most tension, where it is limited</source>
        <translation>有限制时的最大张力</translation>
    </message>
    <message>
        <source>Untouched part</source>
        <translation>不变部分</translation>
    </message>
    <message>
        <source>Share of the limit below which “partial tanh” changes nothing</source>
        <translation>上限的这一比例以下，“部分 Tanh”不改变张力</translation>
    </message>
    <message>
        <source>Slack: pulls only</source>
        <translation>松弛：只拉不推</translation>
    </message>
    <message>
        <source>Its two bodies may collide</source>
        <translation>两端物体可以碰撞</translation>
    </message>
    <message>
        <source>Tangible: others bounce off it</source>
        <translation>有形：其他物体会弹开</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>属于</translation>
    </message>
    <message>
        <source>Tags that say what it is</source>
        <translation>说明其身份的标签</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Two bodies meet when each touches a tag that the other has</source>
        <translation>双方各自接触对方拥有的某个标签时，两个物体才会相碰</translation>
    </message>
    <message>
        <source>Of the level, as players see it</source>
        <translation>关卡的名称，玩家可见</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Who made it</source>
        <translation>制作者</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>描述</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Lives</source>
        <translation>生命</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>可尝试的次数</translation>
    </message>
    <message>
        <source>Tow range</source>
        <translation>牵引距离</translation>
    </message>
    <message>
        <source>Greatest distance of ship and payload at which the rope can be attached</source>
        <translation>可挂上绳索时飞船与载荷的最大距离</translation>
    </message>
    <message>
        <source>Towing turns gravity round</source>
        <translation>牵引使重力反转</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>重力</translation>
    </message>
    <message>
        <source>Acceleration of everything that falls</source>
        <translation>一切下落物体的加速度</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>时间步</translation>
    </message>
    <message>
        <source>Time that one update simulates</source>
        <translation>一个时间步所模拟的时间</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>迭代次数</translation>
    </message>
    <message>
        <source>Passes of motion and collision in one update; more are more exact and slower</source>
        <translation>每个时间步中运动和碰撞的计算次数；越多越精确，也越慢</translation>
    </message>
    <message>
        <source>Sub-steps</source>
        <translation>子步数</translation>
    </message>
    <message>
        <source>Steps of motion in one iteration</source>
        <translation>一次迭代中的运动步数</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>飞船</translation>
    </message>
    <message>
        <source>Tow rope</source>
        <translation>牵引绳</translation>
    </message>
    <message>
        <source>Bodies at rest sleep</source>
        <translation>静止的物体休眠</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>推力</translation>
    </message>
    <message>
        <source>Force along the nose of the ship</source>
        <translation>沿飞船机头方向的力</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>转向</translation>
    </message>
    <message>
        <source>How fast the ship begins to turn while a direction is held</source>
        <translation>按住方向时飞船开始转动的快慢</translation>
    </message>
    <message>
        <source>Of the ship alone</source>
        <translation>仅飞船自身</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Of the rectangle, along its own side; the middle stays where it is</source>
        <translation>矩形沿自身边的尺寸；中心保持不动</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
</context>
<context>
    <name>KeyFileTexts</name>
    <message>
        <source>“%1” needs a list of keys, as in [&quot;Ctrl+S&quot;].</source>
        <translation>“%1”需要按键列表，例如 [&quot;Ctrl+S&quot;]。</translation>
    </message>
    <message>
        <source>“%1” of “%2” is no key.</source>
        <translation>“%2”的“%1”不是按键。</translation>
    </message>
    <message>
        <source>%1 is given to “%2” and to “%3”.</source>
        <translation>%1 同时分配给“%2”和“%3”。</translation>
    </message>
    <message>
        <source>Line %1 is no JSON: %2.</source>
        <translation>第 %1 行不是 JSON：%2。</translation>
    </message>
    <message>
        <source>These keys were written by a newer version of the program.</source>
        <translation>这些按键由更新版本的程序写入。</translation>
    </message>
    <message>
        <source>There are no keys in it; it should look like {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}.</source>
        <translation>其中没有按键；格式应为 {&quot;schema&quot;: 1, &quot;keys&quot;: {…}}。</translation>
    </message>
</context>
<context>
    <name>KeyTexts</name>
    <message>
        <source>That is no single key.</source>
        <translation>这不是单个按键。</translation>
    </message>
    <message>
        <source>%1 belongs to the drawing board and cannot be given away.</source>
        <translation>%1 属于画布，不能另作他用。</translation>
    </message>
    <message>
        <source>%1 goes from field to field and cannot be given away.</source>
        <translation>%1 用于在字段间切换，不能另作他用。</translation>
    </message>
    <message>
        <source>“%1” works while a game is running too, when plain keys are the game&apos;s: use Ctrl, Alt or a function key with it.</source>
        <translation>“%1”在游戏运行时也有效，而此时普通按键归游戏使用：请配合 Ctrl、Alt 或使用功能键。</translation>
    </message>
    <message>
        <source>In the game</source>
        <translation>游戏中</translation>
    </message>
    <message>
        <source>%1 cannot be a key of the game: choose one without Ctrl and Alt that is no function key.</source>
        <translation>%1 不能用作游戏按键：请选择不带 Ctrl 和 Alt 且不是功能键的按键。</translation>
    </message>
    <message>
        <source>%1 always shows the menu of the game.</source>
        <translation>%1 始终显示游戏菜单。</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Click · Shift or Ctrl + click</source>
        <translation>单击 · Shift 或 Ctrl + 单击</translation>
    </message>
    <message>
        <source>Select · add to the selection or take from it</source>
        <translation>选择 · 加入或移出选择</translation>
    </message>
    <message>
        <source>Drag on empty space</source>
        <translation>在空白处拖动</translation>
    </message>
    <message>
        <source>Select with a rubber band; Alt or B: only what lies wholly inside</source>
        <translation>框选；Alt 或 B：仅选完全在内的对象</translation>
    </message>
    <message>
        <source>Alt + click · B + click</source>
        <translation>Alt + 单击 · B + 单击</translation>
    </message>
    <message>
        <source>Select the next object underneath; a right click lists them all</source>
        <translation>选择下面的下一个对象；右击列出全部</translation>
    </message>
    <message>
        <source>Alt + drag · B + drag</source>
        <translation>Alt + 拖动 · B + 拖动</translation>
    </message>
    <message>
        <source>Move the selection from anywhere</source>
        <translation>从任意处移动所选对象</translation>
    </message>
    <message>
        <source>Enter or right click</source>
        <translation>Enter 或右击</translation>
    </message>
    <message>
        <source>End the shape that is being drawn</source>
        <translation>结束正在绘制的形状</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
    <message>
        <source>Take back the last point</source>
        <translation>撤销上一个点</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Cancel: gesture, shape, selection, tool</source>
        <translation>取消：手势、形状、选择、工具</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>方向键</translation>
    </message>
    <message>
        <source>Move the selection a little; Shift: a grid step; Alt: a pixel</source>
        <translation>微移所选对象；Shift：一个网格步长；Alt：一个像素</translation>
    </message>
    <message>
        <source>Wheel · pinch</source>
        <translation>滚轮 · 捏合</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>在指针处缩放</translation>
    </message>
    <message>
        <source>Middle or right drag · Space + drag · two fingers</source>
        <translation>中键或右键拖动 · 空格 + 拖动 · 双指</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>移动视图</translation>
    </message>
    <message>
        <source>On the drawing board</source>
        <translation>在画布上</translation>
    </message>
    <message>
        <source>Thrust</source>
        <translation>推进</translation>
    </message>
    <message>
        <source>Tow the payload when it is near; again: let it go</source>
        <translation>靠近载荷时牵引；再按：放开</translation>
    </message>
    <message>
        <source>Hold the game and show the menu</source>
        <translation>暂停游戏并显示菜单</translation>
    </message>
    <message>
        <source>Let the view follow the ship again</source>
        <translation>让视图重新跟随飞船</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>向左转</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>向右转</translation>
    </message>
    <message>
        <source>Hold the game, or go on</source>
        <translation>暂停或继续游戏</translation>
    </message>
    <message>
        <source>Hold the game and advance it by one update</source>
        <translation>暂停游戏并前进一步</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>重新开始关卡</translation>
    </message>
    <message>
        <source>Let time run slower</source>
        <translation>让时间减慢</translation>
    </message>
    <message>
        <source>Let time run faster</source>
        <translation>让时间加快</translation>
    </message>
    <message>
        <source>While held: one update back</source>
        <translation>暂停时：后退一个时间步</translation>
    </message>
    <message>
        <source>While held: one update on</source>
        <translation>暂停时：前进一个时间步</translation>
    </message>
    <message>
        <source>Turn time back, as long as the key is held</source>
        <translation>按住该键期间让时间倒流</translation>
    </message>
    <message>
        <source>Shift · Ctrl while moving or drawing</source>
        <translation>移动或绘制时 Shift · Ctrl</translation>
    </message>
    <message>
        <source>Keep to an axis or to steps of 15° · switch snapping off or on for the moment</source>
        <translation>保持在轴向或 15° 步进 · 暂时关闭或打开吸附</translation>
    </message>
    <message>
        <source>Shift · Ctrl while drawing a rectangle</source>
        <translation>绘制矩形时 Shift · Ctrl</translation>
    </message>
    <message>
        <source>From its middle · a square</source>
        <translation>从中心 · 正方形</translation>
    </message>
    <message>
        <source>Shift · Ctrl · Alt while scaling</source>
        <translation>缩放时 Shift · Ctrl · Alt</translation>
    </message>
    <message>
        <source>About the middle · keep the proportions · switch snapping off or on</source>
        <translation>以中心为基准 · 保持比例 · 关闭或打开吸附</translation>
    </message>
    <message>
        <source>Shift · Ctrl while turning</source>
        <translation>旋转时 Shift · Ctrl</translation>
    </message>
    <message>
        <source>About the opposite corner · in steps of 15°</source>
        <translation>绕对角 · 以 15° 步进</translation>
    </message>
</context>
<context>
    <name>Legend</name>
    <message>
        <source>Bounding box</source>
        <translation>包围盒</translation>
    </message>
    <message>
        <source>Box of the broad phase, with room to move</source>
        <translation>粗测阶段包围盒，留有移动余量</translation>
    </message>
    <message>
        <source>Largest circle about the centroid</source>
        <translation>以形心为圆心的最大圆</translation>
    </message>
    <message>
        <source>Way of the next second</source>
        <translation>下一秒的路径</translation>
    </message>
    <message>
        <source>Up, 1 m</source>
        <translation>上方，1 m</translation>
    </message>
    <message>
        <source>Free side, 1 m</source>
        <translation>自由侧，1 m</translation>
    </message>
    <message>
        <source>Solid band behind the wall</source>
        <translation>墙后的实心带</translation>
    </message>
    <message>
        <source>Cell of what stands still</source>
        <translation>静止物体的单元</translation>
    </message>
    <message>
        <source>Cell of what moves</source>
        <translation>运动物体的单元</translation>
    </message>
    <message>
        <source>Point of contact</source>
        <translation>接触点</translation>
    </message>
    <message>
        <source>Near, not touching yet</source>
        <translation>接近，尚未接触</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>法线</translation>
    </message>
    <message>
        <source>Pressed to half its length</source>
        <translation>压缩到一半长度</translation>
    </message>
    <message>
        <source>At its natural length</source>
        <translation>自然长度</translation>
    </message>
    <message>
        <source>Stretched by half its length</source>
        <translation>拉伸到一倍半</translation>
    </message>
    <message>
        <source>Way, older ones fainter</source>
        <translation>路径，越早越淡</translation>
    </message>
    <message>
        <source>Center of mass and axes</source>
        <translation>质心和坐标轴</translation>
    </message>
    <message>
        <source>Name of the object</source>
        <translation>对象的名称</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>Deep enough for what comes</source>
        <translation>厚度足以挡住来物</translation>
    </message>
    <message>
        <source>Passed through in one iteration</source>
        <translation>一次迭代即被穿透</translation>
    </message>
    <message>
        <source>The selection collides with it</source>
        <translation>所选对象会与之碰撞</translation>
    </message>
    <message>
        <source>The selection passes through</source>
        <translation>所选对象会穿过</translation>
    </message>
    <message>
        <source>One color an island</source>
        <translation>每个孤岛一种颜色</translation>
    </message>
    <message>
        <source>The color of the first tag; a dot for each further one</source>
        <translation>第一个标签的颜色；其余每个标签一个圆点</translation>
    </message>
    <message>
        <source>Force; 1 m is the weight of the lighter one, 2 m ten times as much</source>
        <translation>力；1 m 为较轻者的重量，2 m 为其十倍</translation>
    </message>
    <message>
        <source>Way in the time that is kept</source>
        <translation>保留时间内的轨迹</translation>
    </message>
    <message>
        <source>Way in a future given up, dashed</source>
        <translation>已放弃的未来轨迹（虚线）</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>One-way wall</source>
        <translation>单向墙</translation>
    </message>
    <message>
        <source>Two-way line</source>
        <translation>双向线</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>Body</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>Ship</source>
        <translation>飞船</translation>
    </message>
    <message>
        <source>Payload</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Connector</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1 at %2; %3</source>
        <translation>%1，位于 %2; %3</translation>
    </message>
</context>
<context>
    <name>ObjectFilter</name>
    <message>
        <source>wall</source>
        <translation>墙</translation>
    </message>
    <message>
        <source>line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>static</source>
        <translation>静态</translation>
    </message>
    <message>
        <source>kinematic</source>
        <translation>运动学</translation>
    </message>
    <message>
        <source>dynamic</source>
        <translation>动态</translation>
    </message>
    <message>
        <source>ship</source>
        <translation>飞船</translation>
    </message>
    <message>
        <source>payload</source>
        <translation>载荷</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>connector</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>group</source>
        <translation>组</translation>
    </message>
    <message>
        <source>layer</source>
        <translation>图层</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>隐藏</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>锁定</translation>
    </message>
</context>
<context>
    <name>Panels</name>
    <message>
        <source>&amp;Inspector</source>
        <translation>检查器(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Outliner</source>
        <translation>大纲视图(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Problems</source>
        <translation>问题(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>节点(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;History</source>
        <translation>历史(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Minimap</source>
        <translation>小地图(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Level Properties</source>
        <translation>关卡属性(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Tag Matrix</source>
        <translation>标签矩阵(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Differences</source>
        <translation>差异(&amp;D)</translation>
    </message>
    <message>
        <source>Show or hide this panel</source>
        <translation>显示或隐藏此面板</translation>
    </message>
    <message>
        <source>&amp;Flights</source>
        <translation>飞行记录(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Run Changes</source>
        <translation>运行中的更改(&amp;R)</translation>
    </message>
    <message>
        <source>E&amp;xplain</source>
        <translation>解释(&amp;X)</translation>
    </message>
    <message>
        <source>Plot&amp;s</source>
        <translation>曲线图(&amp;S)</translation>
    </message>
    <message>
        <source>Profil&amp;e</source>
        <translation>性能分析(&amp;F)</translation>
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
        <translation>角度</translation>
    </message>
    <message>
        <source>velocity to the right</source>
        <translation>向右的速度</translation>
    </message>
    <message>
        <source>velocity upwards</source>
        <translation>向上的速度</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>angular velocity</source>
        <translation>角速度</translation>
    </message>
    <message>
        <source>force to the right</source>
        <translation>向右的力</translation>
    </message>
    <message>
        <source>force upwards</source>
        <translation>向上的力</translation>
    </message>
    <message>
        <source>force of contacts</source>
        <translation>接触力</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>动能</translation>
    </message>
    <message>
        <source>potential energy</source>
        <translation>势能</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>能量</translation>
    </message>
    <message>
        <source>momentum to the right</source>
        <translation>向右的动量</translation>
    </message>
    <message>
        <source>momentum upwards</source>
        <translation>向上的动量</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>角动量</translation>
    </message>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>张力</translation>
    </message>
    <message>
        <source>elastic energy</source>
        <translation>弹性势能</translation>
    </message>
    <message>
        <source>energy of everything</source>
        <translation>系统总能量</translation>
    </message>
    <message>
        <source>kinetic energy of everything</source>
        <translation>系统动能</translation>
    </message>
    <message>
        <source>potential energy of everything</source>
        <translation>系统势能</translation>
    </message>
    <message>
        <source>elastic energy of everything</source>
        <translation>系统弹性势能</translation>
    </message>
    <message>
        <source>drift of energy</source>
        <translation>能量漂移</translation>
    </message>
    <message>
        <source>momentum of everything to the right</source>
        <translation>系统向右的动量</translation>
    </message>
    <message>
        <source>momentum of everything upwards</source>
        <translation>系统向上的动量</translation>
    </message>
    <message>
        <source>drift of momentum</source>
        <translation>动量漂移</translation>
    </message>
    <message>
        <source>angular momentum of everything</source>
        <translation>整体角动量</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>更改</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>运动</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>配对</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>求解器</translation>
    </message>
    <message>
        <source>Time of impact</source>
        <translation>碰撞时刻</translation>
    </message>
    <message>
        <source>Crushing</source>
        <translation>挤压</translation>
    </message>
    <message>
        <source>Advance</source>
        <translation>位置更新</translation>
    </message>
    <message>
        <source>Touches</source>
        <translation>触碰</translation>
    </message>
    <message>
        <source>Sleep</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>ProfilePanel</name>
    <message>
        <source>Static bodies</source>
        <translation>静态物体</translation>
    </message>
    <message>
        <source>Kinematic bodies</source>
        <translation>运动学物体</translation>
    </message>
    <message>
        <source>Dynamic bodies</source>
        <translation>动态物体</translation>
    </message>
    <message>
        <source>Awake</source>
        <translation>活动中</translation>
    </message>
    <message>
        <source>Asleep</source>
        <translation>休眠</translation>
    </message>
    <message>
        <source>Connectors</source>
        <translation>连接件</translation>
    </message>
    <message>
        <source>Pairs that may meet</source>
        <translation>可能相遇的物体对</translation>
    </message>
    <message>
        <source>Pairs that touch</source>
        <translation>相互接触的物体对</translation>
    </message>
    <message>
        <source>Islands</source>
        <translation>岛</translation>
    </message>
    <message>
        <source>Leaves of the quadtrees</source>
        <translation>四叉树的叶节点</translation>
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
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>退格</translation>
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
        <translation>已有同名标签。</translation>
    </message>
    <message>
        <source>That is how a tag without a name is written.</source>
        <translation>这是无名标签的写法。</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.</source>
        <translation>绘制关卡并驾船飞行：关卡编辑器和物理沙盒。</translation>
    </message>
    <message>
        <source>Level files to open; without any, what was open last.</source>
        <translation>要打开的关卡文件；不指定则打开上次的内容。</translation>
    </message>
</context>
<context>
    <name>messages</name>
    <message>
        <source>The file declares entities of its own (line %1), which are not read because they can be made to grow without end. Save it as plain SVG, for example with Inkscape, and try again.</source>
        <translation>文件声明了自己的实体（第 %1 行）；由于实体可能无限膨胀，因此不读取。请另存为普通 SVG（例如用 Inkscape）后重试。</translation>
    </message>
    <message>
        <source>The import was stopped; nothing was changed.</source>
        <translation>导入已停止；未做任何更改。</translation>
    </message>
    <message>
        <source>The file is compressed. Unpack it first, or save it as plain SVG instead of SVGZ.</source>
        <translation>文件已压缩。请先解压，或另存为普通 SVG 而不是 SVGZ。</translation>
    </message>
    <message>
        <source>This is no file that can be imported: SVG drawings, maps of Tiled (.tmx, .tmj) and scenes of R.U.B.E. (.json) can.</source>
        <translation>此文件无法导入：可导入 SVG 图形、Tiled 地图（.tmx、.tmj）和 R.U.B.E. 场景（.json）。</translation>
    </message>
    <message>
        <source>This is a level already: open it instead of importing it.</source>
        <translation>这已经是关卡：请直接打开，无需导入。</translation>
    </message>
    <message>
        <source>This is a tileset or a template of Tiled, which draws nothing. Import a map.</source>
        <translation>这是 Tiled 的图块集或模板，不绘制任何内容。请导入地图。</translation>
    </message>
    <message>
        <source>At this scale something would lie more than %1 m away. Choose a smaller scale.</source>
        <translation>按此比例，会有内容超出 %1 m 之外。请选择更小的比例。</translation>
    </message>
    <message>
        <source>The result would have more than %1 vertices. Choose a larger tolerance.</source>
        <translation>结果的顶点会超过 %1 个。请选择更大的容差。</translation>
    </message>
    <message>
        <source>There is nothing in this file that could become part of a level.</source>
        <translation>此文件中没有可成为关卡内容的东西。</translation>
    </message>
    <message>
        <source>Text was left out (%4). Turn it into paths to have it.</source>
        <translation>已略去文本（%4）。如需保留，请先转换为路径。</translation>
    </message>
    <message>
        <source>Pictures were left out (%4).</source>
        <translation>已略去图片（%4）。</translation>
    </message>
    <message>
        <source>Content in another language than SVG was left out (%4).</source>
        <translation>已略去非 SVG 语言的内容（%4）。</translation>
    </message>
    <message>
        <source>Animations were left out (%4).</source>
        <translation>已略去动画（%4）。</translation>
    </message>
    <message>
        <source>Scripts were left out (%4).</source>
        <translation>已略去脚本（%4）。</translation>
    </message>
    <message>
        <source>Some selectors of a style sheet are not understood (%4): what they say of fill and stroke was not taken over.</source>
        <translation>样式表的某些选择器无法识别（%4）：其中的填充和描边未采用。</translation>
    </message>
    <message>
        <source>What is not displayed was left out (%4).</source>
        <translation>已略去不显示的内容（%4）。</translation>
    </message>
    <message>
        <source>Shapes without fill and stroke were left out (%4).</source>
        <translation>已略去没有填充和描边的形状（%4）。</translation>
    </message>
    <message>
        <source>A transform is not understood and was left out (%4).</source>
        <translation>有变换无法识别，已略去（%4）。</translation>
    </message>
    <message>
        <source>Clips and masks were not applied: shapes are there as a whole (%4).</source>
        <translation>未应用剪裁和蒙版：形状完整保留（%4）。</translation>
    </message>
    <message>
        <source>Filters were not applied (%4).</source>
        <translation>未应用滤镜（%4）。</translation>
    </message>
    <message>
        <source>References to what is not in the file, or to themselves, were left out (%4): %3</source>
        <translation>已略去指向文件外内容或自身的引用（%4）：%3</translation>
    </message>
    <message>
        <source>The data of shapes has a mistake; they are there up to it (%4).</source>
        <translation>形状数据有错误；保留到出错处为止（%4）。</translation>
    </message>
    <message>
        <source>Shapes without any extent were left out (%4).</source>
        <translation>已略去没有大小的形状（%4）。</translation>
    </message>
    <message>
        <source>Areas with holes, or in several parts, were cut into several polygons (%4).</source>
        <translation>带孔或分成多块的区域已切成多个多边形（%4）。</translation>
    </message>
    <message>
        <source>Polygons of more than 1024 vertices became walls (%4). A larger tolerance makes fewer vertices.</source>
        <translation>顶点超过 1024 个的多边形已变为墙（%4）。增大容差可减少顶点。</translation>
    </message>
    <message>
        <source>Areas that cross themselves very often became walls (%4).</source>
        <translation>自交过多的区域已变为墙（%4）。</translation>
    </message>
    <message>
        <source>Layers of tiles were left out, for a level has no tiles: %3 (%4). Objects of object layers are taken over.</source>
        <translation>已略去图块层，因为关卡没有图块：%3（%4）。对象层中的对象已采用。</translation>
    </message>
    <message>
        <source>Layers of pictures were left out: %3 (%4).</source>
        <translation>已略去图像层：%3（%4）。</translation>
    </message>
    <message>
        <source>Tilesets are not needed and were not read: %3.</source>
        <translation>不需要图块集，未读取：%3。</translation>
    </message>
    <message>
        <source>Objects that are tiles were left out (%4).</source>
        <translation>已略去图块对象（%4）。</translation>
    </message>
    <message>
        <source>Objects made of templates were left out, for these are in other files (%4). Detach them in Tiled.</source>
        <translation>已略去由模板生成的对象，因为模板在其他文件中（%4）。请在 Tiled 中分离它们。</translation>
    </message>
    <message>
        <source>Objects of a form that is not known here were left out (%4).</source>
        <translation>已略去形式未知的对象（%4）。</translation>
    </message>
    <message>
        <source>Points were left out (%4): only those of the class “ship” or “payload” become something.</source>
        <translation>已略去点（%4）：只有类为“ship”或“payload”的点才会采用。</translation>
    </message>
    <message>
        <source>Properties that mean nothing here were left out (%4): %3.</source>
        <translation>已略去此处无意义的属性（%4）：%3。</translation>
    </message>
    <message>
        <source>The opacity of layers was not taken over: %3 (%4).</source>
        <translation>未采用图层的不透明度：%3（%4）。</translation>
    </message>
    <message>
        <source>The parallax of layers was not taken over: %3 (%4).</source>
        <translation>未采用图层的视差：%3（%4）。</translation>
    </message>
    <message>
        <source>Gravity was not taken over (%4): the level keeps its own.</source>
        <translation>未采用重力（%4）：关卡保留自己的重力。</translation>
    </message>
    <message>
        <source>Numbers that a level cannot have were brought into its range (%4): %3.</source>
        <translation>关卡不允许的数值已调整到允许范围（%4）：%3。</translation>
    </message>
    <message>
        <source>Fixtures without a sound shape were left out (%4).</source>
        <translation>已略去没有有效形状的夹具（%4）。</translation>
    </message>
    <message>
        <source>Group indices of filters were not taken over (%4): %3</source>
        <translation>未采用过滤器的组索引（%4）：%3</translation>
    </message>
    <message>
        <source>Fixtures of one body differ in material or filter: those of the first were taken (%4): %3</source>
        <translation>同一物体的夹具材质或过滤器不同：采用了第一个的设置（%4）：%3</translation>
    </message>
    <message>
        <source>Sensors of bodies that also have solid fixtures were left out (%4): %3</source>
        <translation>已略去同时带有实心夹具的物体上的传感器（%4）：%3</translation>
    </message>
    <message>
        <source>Settings of bodies that mean nothing here were left out (%4): %3</source>
        <translation>已略去此处无意义的物体设置（%4）：%3</translation>
    </message>
    <message>
        <source>Bodies without fixtures were left out (%4): %3</source>
        <translation>已略去没有夹具的物体（%4）：%3</translation>
    </message>
    <message>
        <source>Joints that no connector can be were left out (%4): %3</source>
        <translation>已略去无法成为连接件的关节（%4）：%3</translation>
    </message>
    <message>
        <source>Rigid joints became stiff connectors (%4): %3</source>
        <translation>刚性关节已变为高刚度连接件（%4）：%3</translation>
    </message>
    <message>
        <source>The level has a ship, a payload or a finish already; those of the file were left out.</source>
        <translation>关卡已有飞船、载荷或终点；已略去文件中的这些对象。</translation>
    </message>
    <message>
        <source>All 32 tags are taken; these were left out: %3</source>
        <translation>32 个标签均已占用；已略去：%3</translation>
    </message>
    <message>
        <source>One-way wall · click: first point · drag: first segment · Ctrl: snap off/on · what comes from the left of the drawing direction is stopped</source>
        <translation>单向墙 · 单击：第一个点 · 拖动：第一条线段 · Ctrl：切换吸附 · 从绘制方向左侧来的会被挡住</translation>
    </message>
    <message>
        <source>Points: %1 · click: add · click the first point: close · Enter or right click: end · Backspace: undo point · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>点数：%1 · 单击：添加 · 单击第一个点：闭合 · Enter 或右击：结束 · Backspace：撤销点 · 数字键：输入长度和角度 · Shift：15° · Ctrl：切换吸附 · 长度 %2 m，角度 %3°</translation>
    </message>
    <message>
        <source>Points: %1 · click: close the chain · Enter or right click: end it open · Escape: cancel</source>
        <translation>点数：%1 · 单击：闭合链 · Enter 或右击：不闭合结束 · Esc：取消</translation>
    </message>
    <message>
        <source>A chain of walls needs two points: click to add another, or Escape to cancel</source>
        <translation>墙链需要两个点：单击再添加一个，或按 Esc 取消</translation>
    </message>
    <message>
        <source>This is where the last point is already: move on before you click</source>
        <translation>上一个点已在此处：请先移开再单击</translation>
    </message>
    <message>
        <source>Click or drag: go on with this chain, which keeps its direction · Alt or B + click: begin a chain of its own here</source>
        <translation>单击或拖动：继续此链，方向不变 · Alt 或 B + 单击：在此另起一条链</translation>
    </message>
    <message>
        <source>Click: close the chain at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>单击：与另一端闭合此链 · Enter 或右击：不闭合结束 · Esc：保持原样</translation>
    </message>
    <message>
        <source>Two-sided wall · click: first point · drag: first segment · Ctrl: snap off/on</source>
        <translation>双向线 · 单击：第一个点 · 拖动：第一条线段 · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>Click or drag: go on with this line · Alt or B + click: begin a line of its own here</source>
        <translation>单击或拖动：继续此线 · Alt 或 B + 单击：在此另起一条线</translation>
    </message>
    <message>
        <source>Click: close the line at its other end · Enter or right click: end it open · Escape: leave it as it was</source>
        <translation>单击：与另一端闭合此线 · Enter 或右击：不闭合结束 · Esc：保持原样</translation>
    </message>
    <message>
        <source>Polygon · click: first corner · drag: first side · Ctrl: snap off/on</source>
        <translation>多边形 · 单击：第一个角点 · 拖动：第一条边 · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>Corners: %1 · click: add · click the first corner, Enter or right click: close · Backspace: undo corner · digits: type length and angle · Shift: 15° · Ctrl: snap off/on · length %2 m, angle %3°</source>
        <translation>角点：%1 · 单击：添加 · 单击第一个角点、Enter 或右击：闭合 · Backspace：撤销角点 · 数字键：输入长度和角度 · Shift：15° · Ctrl：切换吸附 · 长度 %2 m，角度 %3°</translation>
    </message>
    <message>
        <source>Corners: %1 · click: close the polygon · Escape: cancel</source>
        <translation>角点：%1 · 单击：闭合多边形 · Esc：取消</translation>
    </message>
    <message>
        <source>A polygon needs three corners: click to add another, or Escape to cancel</source>
        <translation>多边形需要三个角点：单击再添加一个，或按 Esc 取消</translation>
    </message>
    <message>
        <source>This is where the last corner is already: move on before you click</source>
        <translation>上一个角点已在此处：请先移开再单击</translation>
    </message>
    <message>
        <source>This side would run through another one, and a polygon must not cross itself · move on before you click</source>
        <translation>此边会穿过另一条边，而多边形不能自交 · 请先移开再单击</translation>
    </message>
    <message>
        <source>The polygon crosses itself where it is marked and cannot be finished like this · Backspace: undo corner</source>
        <translation>多边形在标记处自交，无法这样完成 · Backspace：撤销角点</translation>
    </message>
    <message>
        <source>Closing it here would make the polygon cross itself · Backspace: undo corner · click: go on</source>
        <translation>在此闭合会使多边形自交 · Backspace：撤销角点 · 单击：继续</translation>
    </message>
    <message>
        <source>All corners lie on one line: a polygon needs an inside · click: add a corner · Backspace: undo corner</source>
        <translation>所有角点在一条直线上：多边形需要内部 · 单击：添加角点 · Backspace：撤销角点</translation>
    </message>
    <message>
        <source>Rectangle · drag from corner to corner, or click both, or click one and type the size · Shift: from the middle · Ctrl: square</source>
        <translation>矩形 · 从角拖到角，或依次单击两角，或单击一角再输入大小 · Shift：从中心 · Ctrl：正方形</translation>
    </message>
    <message>
        <source>Width %1 m, height %2 m · click or release: done · Shift: from the middle · Ctrl: square · Alt or B: snap off/on · Escape: cancel</source>
        <translation>宽 %1 m，高 %2 m · 单击或松开：完成 · Shift：从中心 · Ctrl：正方形 · Alt 或 B：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>A rectangle needs width and height: move on before you click or release</source>
        <translation>矩形需要宽度和高度：请先移开再单击或松开</translation>
    </message>
    <message>
        <source>Moving body · drag: rectangle · click: first corner of a polygon · then its velocity · Shift: from the middle · Ctrl: square</source>
        <translation>运动物体 · 拖动：矩形 · 单击：多边形的第一个角点 · 然后设速度 · Shift：从中心 · Ctrl：正方形</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · click or drag: set it · digits: type it · Shift: 15° · Ctrl: snap off/on · Enter, right click or Escape: leave the body at rest</source>
        <translation>速度 %1 m/s，%2° · 单击或拖动：设定 · 数字键：输入 · Shift：15° · Ctrl：切换吸附 · Enter、右击或 Esc：让物体静止</translation>
    </message>
    <message>
        <source>Velocity %1 m/s, %2° · Shift: 15° · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>速度 %1 m/s，%2° · Shift：15° · Ctrl：切换吸附 · 松开：完成 · Esc：取消</translation>
    </message>
    <message>
        <source>Drag: change the velocity of this body, a metre for each m/s</source>
        <translation>拖动：更改此物体的速度，每 m/s 对应一米</translation>
    </message>
    <message>
        <source>Connector · drag from one body to another, or click both · anchors snap to nodes, middles and the grid</source>
        <translation>连接件 · 从一个物体拖到另一个，或依次单击两者 · 锚点吸附到节点、中点和网格</translation>
    </message>
    <message>
        <source>Drag or click: connect “%1” with another body</source>
        <translation>拖动或单击：把“%1”与另一个物体连接</translation>
    </message>
    <message>
        <source>Drag or click: connect this fixed body with another one</source>
        <translation>拖动或单击：把此固定物体与另一个物体连接</translation>
    </message>
    <message>
        <source>Drag or click: connect this moving body with another one</source>
        <translation>拖动或单击：把此运动物体与另一个物体连接</translation>
    </message>
    <message>
        <source>Drag or click: connect this loose body with another one</source>
        <translation>拖动或单击：把此自由物体与另一个物体连接</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with “%2” · Escape: cancel</source>
        <translation>长度 %1 m · 松开或单击：与“%2”连接 · Esc：取消</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this fixed body · Escape: cancel</source>
        <translation>长度 %1 m · 松开或单击：与此固定物体连接 · Esc：取消</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this moving body · Escape: cancel</source>
        <translation>长度 %1 m · 松开或单击：与此运动物体连接 · Esc：取消</translation>
    </message>
    <message>
        <source>Length %1 m · release or click: connect with this loose body · Escape: cancel</source>
        <translation>长度 %1 m · 松开或单击：与此自由物体连接 · Esc：取消</translation>
    </message>
    <message>
        <source>Neither of these two bodies can be moved by a connector, one should be dynamic · release or click: connect them all the same · length %1 m</source>
        <translation>连接件无法移动这两个物体，其中应有一个为动态 · 松开或单击：仍然连接 · 长度 %1 m</translation>
    </message>
    <message>
        <source>This is the body where the connector begins: it needs another one</source>
        <translation>这是连接件起始的物体：需要另一个物体</translation>
    </message>
    <message>
        <source>Connectors join bodies; ship, payload and finish are none</source>
        <translation>连接件连接物体；飞船、载荷和终点不是物体</translation>
    </message>
    <message>
        <source>There is no body here: a connector leads from one body to another</source>
        <translation>此处没有物体：连接件从一个物体通向另一个物体</translation>
    </message>
    <message>
        <source>There was no body where the drag began: press on one, then drag to another</source>
        <translation>拖动起始处没有物体：请在一个物体上按下，再拖到另一个</translation>
    </message>
    <message>
        <source>Nothing was connected: release the button over another body</source>
        <translation>未连接任何物体：请在另一个物体上松开按键</translation>
    </message>
    <message>
        <source>Length and angle · Tab: the other one · an empty one is left to the pointer · Enter or click: place the point · Escape: back to the pointer</source>
        <translation>长度和角度 · Tab：切换到另一个 · 留空则由指针决定 · Enter 或单击：放置点 · Esc：回到指针</translation>
    </message>
    <message>
        <source>Speed and direction · Tab: the other one · an empty one is left to the pointer · Enter or click: set the velocity · Escape: back to the pointer</source>
        <translation>速率和方向 · Tab：切换到另一个 · 留空则由指针决定 · Enter 或单击：设定速度 · Esc：回到指针</translation>
    </message>
    <message>
        <source>Width and height · Tab: the other one · an empty one is left to the pointer · Enter or click: draw the rectangle · Escape: back to the pointer</source>
        <translation>宽度和高度 · Tab：切换到另一个 · 留空则由指针决定 · Enter 或单击：绘制矩形 · Esc：回到指针</translation>
    </message>
    <message>
        <source>Radius · Enter or click: draw the circle · Escape: back to the pointer</source>
        <translation>半径 · Enter 或单击：绘制圆 · Esc：回到指针</translation>
    </message>
    <message>
        <source>“%1” is no number in metres: type one such as 2.5, 80 cm or 3/4</source>
        <translation>“%1”不是以米为单位的数字：请输入如 2.5、80 cm 或 3/4</translation>
    </message>
    <message>
        <source>“%1” is no angle: type degrees such as 45, −22.5 or 180/7, anticlockwise from the right</source>
        <translation>“%1”不是角度：请输入度数，如 45、−22.5 或 180/7，从右侧起逆时针</translation>
    </message>
    <message>
        <source>“%1” is too small: a size must be more than nothing</source>
        <translation>“%1”太小：大小必须大于零</translation>
    </message>
    <message>
        <source>Circle · drag from the center, or click it and then click or type the radius · Ctrl: snap off/on</source>
        <translation>圆 · 从中心拖动，或单击中心再单击或输入半径 · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>Radius %1 m · click or release: done · Ctrl: snap off/on · Escape: cancel</source>
        <translation>半径 %1 m · 单击或松开：完成 · Ctrl：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>A circle needs a radius: move away from the center before you click</source>
        <translation>圆需要半径：请先离开中心再单击</translation>
    </message>
    <message>
        <source>Guide · drag: move it · drag onto a ruler: delete it · double click: type place, angle and name</source>
        <translation>参考线 · 拖动：移动 · 拖到标尺上：删除 · 双击：输入位置、角度和名称</translation>
    </message>
    <message>
        <source>New guide at %1 m, %2 m · release: done · Ctrl: snap off/on · back onto the ruler or Escape: none</source>
        <translation>新参考线位于 %1 m, %2 m · 松开：完成 · Ctrl：切换吸附 · 拖回标尺或按 Esc：放弃</translation>
    </message>
    <message>
        <source>New guide · drag it into the drawing board · Escape: none</source>
        <translation>新参考线 · 拖入画布 · Esc：放弃</translation>
    </message>
    <message>
        <source>Guide at %1 m, %2 m, %3° · release: done · Shift: turn · Ctrl: snap off/on · onto a ruler: delete · Escape: cancel</source>
        <translation>参考线位于 %1 m, %2 m, %3° · 松开：完成 · Shift：旋转 · Ctrl：切换吸附 · 拖到标尺上：删除 · Esc：取消</translation>
    </message>
    <message>
        <source>Guide on the ruler · release: delete it · Escape: cancel</source>
        <translation>参考线在标尺上 · 松开：删除 · Esc：取消</translation>
    </message>
    <message>
        <source>Measure · drag from one point to the other, or click both · Ctrl: snap off/on</source>
        <translation>测量 · 从一点拖到另一点，或依次单击两点 · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click or release: done · Shift: 15° · Ctrl: snap off/on · Escape: clear</source>
        <translation>%1 m，水平 %2 m，垂直 %3 m，%4° · 单击或松开：完成 · Shift：15° · Ctrl：切换吸附 · Esc：清除</translation>
    </message>
    <message>
        <source>First point · click the other one · Escape: clear</source>
        <translation>第一个点 · 请单击另一点 · Esc：清除</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m，水平 %2 m，垂直 %3 m，%4° · Ctrl+C：复制 · 拖动：重新测量 · Esc：清除</translation>
    </message>
    <message>
        <source>%1 m, across %2 m, upwards %3 m, %4° · click: angle %5° · Ctrl+C: copy · drag: measure anew · Escape: clear</source>
        <translation>%1 m，水平 %2 m，垂直 %3 m，%4° · 单击：角度 %5° · Ctrl+C：复制 · 拖动：重新测量 · Esc：清除</translation>
    </message>
    <message>
        <source>Angle %1° between %2 m and %3 m · Ctrl+C: copy · click or drag: measure anew · Escape: clear</source>
        <translation>%2 m 与 %3 m 之间的角度 %1° · Ctrl+C：复制 · 单击或拖动：重新测量 · Esc：清除</translation>
    </message>
    <message>
        <source>Nodes · click a wall, line, polygon or finish to edit its nodes</source>
        <translation>节点 · 单击墙、线、多边形或终点以编辑其节点</translation>
    </message>
    <message>
        <source>What is selected has no nodes · click a wall, line, polygon or finish to edit it</source>
        <translation>所选对象没有节点 · 单击墙、线、多边形或终点以编辑</translation>
    </message>
    <message>
        <source>Nodes · click or rubber band: select nodes · Shift + Alt + drag: lasso · double click on a segment: insert a node · Escape: done</source>
        <translation>节点 · 单击或框选：选择节点 · Shift + Alt + 拖动：套索 · 双击线段：插入节点 · Esc：完成</translation>
    </message>
    <message>
        <source>Click: edit the nodes of this object · Shift + click: add it to those in edit</source>
        <translation>单击：编辑此对象的节点 · Shift + 单击：加入正在编辑的对象</translation>
    </message>
    <message>
        <source>%1 nodes selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Shift+J: join · Shift+R: turn the part between them round as a chain of its own · Escape: select none</source>
        <translation>已选 %1 个节点 · 拖动：移动 · 方向键：微移 · Delete：删除 · Shift+B：断开 · Shift+J：连接 · Shift+R：把其间部分反转为独立的链 · Esc：取消选择</translation>
    </message>
    <message>
        <source>Node · drag: move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band · Alt while dragging: leave other nodes at this place behind</source>
        <translation>节点 · 拖动：移动 · Shift 或 Ctrl + 单击：加入或移出 · Shift + 拖动：框选 · 拖动时按 Alt：此处的其他节点留在原位</translation>
    </message>
    <message>
        <source>Segment · drag: move both ends · click: select them · double click or Ctrl + Alt + click: insert a node here</source>
        <translation>线段 · 拖动：移动两端 · 单击：选择两端 · 双击或 Ctrl + Alt + 单击：在此插入节点</translation>
    </message>
    <message>
        <source>Click: insert a node here</source>
        <translation>单击：在此插入节点</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>移动 %1 m, %2 m · Shift：沿一条轴 · Ctrl：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>Moving by %1 m, %2 m together with other nodes at this place · Alt: leave them behind · Shift: along one axis · Ctrl: snap off/on · Escape: cancel</source>
        <translation>与此处的其他节点一起移动 %1 m, %2 m · Alt：其他节点留在原位 · Shift：沿一条轴 · Ctrl：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>Two neighbouring nodes lie on one point, which leaves a side without length · move on, or Escape to cancel</source>
        <translation>两个相邻节点在同一点上，使一条边没有长度 · 继续移动，或按 Esc 取消</translation>
    </message>
    <message>
        <source>The polygon crosses itself like this and cannot be played · move on, or Escape to cancel</source>
        <translation>多边形这样会自交，无法试玩 · 继续移动，或按 Esc 取消</translation>
    </message>
    <message>
        <source>Drag: scale the selected nodes · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · click a selected node: turn them instead</source>
        <translation>拖动：缩放所选节点 · Shift：绕中心 · Ctrl：等比 · Alt：切换吸附 · 单击所选节点：改为旋转</translation>
    </message>
    <message>
        <source>Drag: turn the selected nodes · Ctrl: in steps of 15° · click a selected node: scale them instead</source>
        <translation>拖动：旋转所选节点 · Ctrl：按 15° 步进 · 单击所选节点：改为缩放</translation>
    </message>
    <message>
        <source>Scaling to %1 m × %2 m · Shift: about the middle · Ctrl: in proportion · Alt: snap off/on · Escape: cancel</source>
        <translation>缩放到 %1 m × %2 m · Shift：绕中心 · Ctrl：等比 · Alt：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>Turning by %1° · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>旋转 %1° · Ctrl：按 15° 步进 · Esc：取消</translation>
    </message>
    <message>
        <source>Knife · drag a line across walls, lines and polygons to cut them · Shift: 15° · Ctrl: snap off/on</source>
        <translation>切刀 · 拖动一条线穿过墙、线和多边形以切割 · Shift：15° · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>Knife · drag a line across to cut what is selected (%1) · Escape: select nothing, so as to cut everything</source>
        <translation>切刀 · 拖动一条线以切割所选对象 (%1) · Esc：取消选择，从而切割一切</translation>
    </message>
    <message>
        <source>Nothing to cut here yet · chains are cut where the line meets them, polygons where it goes right through</source>
        <translation>此处尚无可切割的内容 · 链在与线相交处切开，多边形在线完全穿过处切开</translation>
    </message>
    <message>
        <source>Ship · click: put it here · drag: turn its nose · Ctrl: snap off/on · choose the tool again for the payload</source>
        <translation>飞船 · 单击：放在此处 · 拖动：旋转船头 · Ctrl：切换吸附 · 再次选择此工具：放置载荷</translation>
    </message>
    <message>
        <source>Nose at %1° · Shift: 15° · release: done · Escape: cancel</source>
        <translation>船头朝向 %1° · Shift：15° · 松开：完成 · Esc：取消</translation>
    </message>
    <message>
        <source>Payload · click: put it here · drag: move it into place · Ctrl: snap off/on · choose the tool again for the finish</source>
        <translation>载荷 · 单击：放在此处 · 拖动：移到位 · Ctrl：切换吸附 · 再次选择此工具：放置终点</translation>
    </message>
    <message>
        <source>Payload at %1 m, %2 m · Ctrl: snap off/on · release: done · Escape: cancel</source>
        <translation>载荷位于 %1 m, %2 m · Ctrl：切换吸附 · 松开：完成 · Esc：取消</translation>
    </message>
    <message>
        <source>Finish line · drag it, or click one end and then click or type the other · Ctrl: snap off/on · choose the tool again for the ship</source>
        <translation>终点线 · 拖出，或单击一端再单击或输入另一端 · Ctrl：切换吸附 · 再次选择此工具：放置飞船</translation>
    </message>
    <message>
        <source>Finish line · click or release at the other end · Shift: 15° · Ctrl: snap off/on · length %1 m, angle %2° · Escape: cancel</source>
        <translation>终点线 · 在另一端单击或松开 · Shift：15° · Ctrl：切换吸附 · 长度 %1 m，角度 %2° · Esc：取消</translation>
    </message>
    <message>
        <source>The finish needs two ends: move away from the first before you click</source>
        <translation>终点线需要两端：请先离开第一端再单击</translation>
    </message>
    <message>
        <source>Click: select · drag: rubber band · Shift + Alt (or B) + drag: lasso · Shift or Ctrl + click: add or remove · Alt or B + click: next object underneath</source>
        <translation>单击：选择 · 拖动：框选 · Shift + Alt（或 B）+ 拖动：套索 · Shift 或 Ctrl + 单击：加入或移出 · Alt 或 B + 单击：下面的下一个对象</translation>
    </message>
    <message>
        <source>Click: select · drag: select and move · Shift or Ctrl + click: add or remove · Shift + drag: rubber band</source>
        <translation>单击：选择 · 拖动：选择并移动 · Shift 或 Ctrl + 单击：加入或移出 · Shift + 拖动：框选</translation>
    </message>
    <message>
        <source>%1 selected · drag: move · click again: turn or scale · Alt or B + drag: move from anywhere · Shift or Ctrl + click: add or remove · Delete: remove · Escape: select nothing</source>
        <translation>已选 %1 项 · 拖动：移动 · 再次单击：旋转或缩放 · Alt 或 B + 拖动：从任意处移动 · Shift 或 Ctrl + 单击：加入或移出 · Delete：删除 · Esc：取消选择</translation>
    </message>
    <message>
        <source>Click: select the group · double click: enter it · Ctrl + click: select by itself · drag: select and move · Shift + click: add or remove</source>
        <translation>单击：选择组 · 双击：进入组 · Ctrl + 单击：单独选择 · 拖动：选择并移动 · Shift + 单击：加入或移出</translation>
    </message>
    <message>
        <source>%1 selected · double click: enter the group · drag: move · click again: turn or scale · Ctrl + click: select by itself · Delete: remove</source>
        <translation>已选 %1 项 · 双击：进入组 · 拖动：移动 · 再次单击：旋转或缩放 · Ctrl + 单击：单独选择 · Delete：删除</translation>
    </message>
    <message>
        <source>Inside a group, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>在组内，已选 %1 项 · 单击选择成员 · Esc 或双击空白处：离开</translation>
    </message>
    <message>
        <source>Inside “%2”, %1 selected · clicks select its members · Escape, or double click on empty ground: leave it</source>
        <translation>在“%2”内，已选 %1 项 · 单击选择成员 · Esc 或双击空白处：离开</translation>
    </message>
    <message>
        <source>%1 selected · Ctrl: only what lies wholly inside · Escape: cancel</source>
        <translation>已选 %1 项 · Ctrl：仅选完全在内的对象 · Esc：取消</translation>
    </message>
    <message>
        <source>Node · drag: move it alone · Alt or B + drag: move the whole object · double click: edit all nodes</source>
        <translation>节点 · 拖动：单独移动 · Alt 或 B + 拖动：移动整个对象 · 双击：编辑所有节点</translation>
    </message>
    <message>
        <source>Drag: scale · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on</source>
        <translation>拖动：缩放 · Shift：绕中心 · Ctrl：保持比例 · Alt 或 B：切换吸附</translation>
    </message>
    <message>
        <source>%1 × %2 m (%3 %, %4 %) · Shift: about the middle · Ctrl: keep the proportions · Alt or B: snap off/on · Escape: cancel</source>
        <translation>%1 × %2 m (%3 %, %4 %) · Shift：绕中心 · Ctrl：保持比例 · Alt 或 B：切换吸附 · Esc：取消</translation>
    </message>
    <message>
        <source>Drag: turn about the pivot · Shift: about the opposite corner · Ctrl: in steps of 15° · click the object: scale</source>
        <translation>拖动：绕轴心旋转 · Shift：绕对角 · Ctrl：按 15° 步进 · 单击对象：缩放</translation>
    </message>
    <message>
        <source>Turning by %1° · Shift: about the opposite corner · Ctrl: in steps of 15° · Escape: cancel</source>
        <translation>旋转 %1° · Shift：绕对角 · Ctrl：按 15° 步进 · Esc：取消</translation>
    </message>
    <message>
        <source>Drag: move the pivot, about which the selection turns · Ctrl: snap off/on</source>
        <translation>拖动：移动轴心，所选对象绕其旋转 · Ctrl：切换吸附</translation>
    </message>
    <message>
        <source>%1 selected · Alt or B: only what lies wholly inside · Escape: cancel</source>
        <translation>已选 %1 项 · Alt 或 B：仅选完全在内的对象 · Esc：取消</translation>
    </message>
    <message>
        <source>Draw one-way walls</source>
        <translation>绘制单向墙</translation>
    </message>
    <message>
        <source>Draw two-sided walls</source>
        <translation>绘制双向线</translation>
    </message>
    <message>
        <source>Draw polygon</source>
        <translation>绘制多边形</translation>
    </message>
    <message>
        <source>Draw circle</source>
        <translation>绘制圆</translation>
    </message>
    <message>
        <source>Draw rectangle</source>
        <translation>绘制矩形</translation>
    </message>
    <message>
        <source>Draw moving body</source>
        <translation>绘制运动物体</translation>
    </message>
    <message>
        <source>Draw connector</source>
        <translation>绘制连接件</translation>
    </message>
    <message>
        <source>Set velocity</source>
        <translation>设定速度</translation>
    </message>
    <message>
        <source>Extend chain</source>
        <translation>延长链</translation>
    </message>
    <message>
        <source>Place ship</source>
        <translation>放置飞船</translation>
    </message>
    <message>
        <source>Place payload</source>
        <translation>放置载荷</translation>
    </message>
    <message>
        <source>Place finish</source>
        <translation>放置终点</translation>
    </message>
    <message>
        <source>Reopen level</source>
        <translation>重新打开关卡</translation>
    </message>
    <message>
        <source>Move object</source>
        <translation>移动对象</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects</source>
        <translation>
            <numerusform>移动 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate object</source>
        <translation>旋转对象</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n objects</source>
        <translation>
            <numerusform>旋转 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale object</source>
        <translation>缩放对象</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n objects</source>
        <translation>
            <numerusform>缩放 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Flip object</source>
        <translation>翻转对象</translation>
    </message>
    <message numerus="yes">
        <source>Flip %n objects</source>
        <translation>
            <numerusform>翻转 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Align object</source>
        <translation>对齐对象</translation>
    </message>
    <message numerus="yes">
        <source>Align %n objects</source>
        <translation>
            <numerusform>对齐 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Distribute object</source>
        <translation>分布对象</translation>
    </message>
    <message numerus="yes">
        <source>Distribute %n objects</source>
        <translation>
            <numerusform>分布 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Reorder object</source>
        <translation>调整对象次序</translation>
    </message>
    <message numerus="yes">
        <source>Reorder %n objects</source>
        <translation>
            <numerusform>调整 %n 个对象的次序</numerusform>
        </translation>
    </message>
    <message>
        <source>Group object</source>
        <translation>编组对象</translation>
    </message>
    <message numerus="yes">
        <source>Group %n objects</source>
        <translation>
            <numerusform>编组 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>取消编组</translation>
    </message>
    <message numerus="yes">
        <source>Ungroup %n groups</source>
        <translation>
            <numerusform>取消 %n 个编组</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another layer</source>
        <translation>把对象移到另一图层</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another layer</source>
        <translation>
            <numerusform>把 %n 个对象移到另一图层</numerusform>
        </translation>
    </message>
    <message>
        <source>Move object to another group</source>
        <translation>把对象移到另一组</translation>
    </message>
    <message numerus="yes">
        <source>Move %n objects to another group</source>
        <translation>
            <numerusform>把 %n 个对象移到另一组</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename object</source>
        <translation>重命名对象</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>显示对象</translation>
    </message>
    <message numerus="yes">
        <source>Show %n objects</source>
        <translation>
            <numerusform>显示 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>解锁对象</translation>
    </message>
    <message numerus="yes">
        <source>Unlock %n objects</source>
        <translation>
            <numerusform>解锁 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>隐藏对象</translation>
    </message>
    <message numerus="yes">
        <source>Hide %n objects</source>
        <translation>
            <numerusform>隐藏 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Isolate object</source>
        <translation>单独显示对象</translation>
    </message>
    <message numerus="yes">
        <source>Isolate %n objects</source>
        <translation>
            <numerusform>单独显示 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>锁定对象</translation>
    </message>
    <message numerus="yes">
        <source>Lock %n objects</source>
        <translation>
            <numerusform>锁定 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Repeat transform</source>
        <translation>重复变换</translation>
    </message>
    <message numerus="yes">
        <source>Repeat transform of %n objects</source>
        <translation>
            <numerusform>重复变换 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>新建图层</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>全部显示</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>全部解锁</translation>
    </message>
    <message>
        <source>Array of one copy</source>
        <translation>单副本阵列</translation>
    </message>
    <message numerus="yes">
        <source>Array of %n copies</source>
        <translation>
            <numerusform>%n 个副本的阵列</numerusform>
        </translation>
    </message>
    <message>
        <source>Unite bodies</source>
        <translation>物体并集</translation>
    </message>
    <message numerus="yes">
        <source>Unite %n objects</source>
        <translation>
            <numerusform>%n 个对象的并集</numerusform>
        </translation>
    </message>
    <message>
        <source>Subtract bodies</source>
        <translation>物体差集</translation>
    </message>
    <message numerus="yes">
        <source>Subtract %n objects</source>
        <translation>
            <numerusform>%n 个对象的差集</numerusform>
        </translation>
    </message>
    <message>
        <source>Intersect bodies</source>
        <translation>物体交集</translation>
    </message>
    <message numerus="yes">
        <source>Intersect %n objects</source>
        <translation>
            <numerusform>%n 个对象的交集</numerusform>
        </translation>
    </message>
    <message>
        <source>Remove points on straight sides</source>
        <translation>移除直边上的点</translation>
    </message>
    <message>
        <source>Merge points</source>
        <translation>合并点</translation>
    </message>
    <message>
        <source>Turn outline round</source>
        <translation>反转轮廓</translation>
    </message>
    <message>
        <source>Reverse wall</source>
        <translation>反转墙</translation>
    </message>
    <message>
        <source>Close gap</source>
        <translation>闭合缺口</translation>
    </message>
    <message>
        <source>Add the missing wall</source>
        <translation>补上缺失的墙</translation>
    </message>
    <message>
        <source>Remove what is there twice</source>
        <translation>移除重复内容</translation>
    </message>
    <message>
        <source>Limit depth</source>
        <translation>限制深度</translation>
    </message>
    <message>
        <source>Choose plain background</source>
        <translation>选用纯色背景</translation>
    </message>
    <message>
        <source>Move out of group</source>
        <translation>移出组</translation>
    </message>
    <message>
        <source>Give a new key</source>
        <translation>赋予新标识</translation>
    </message>
    <message>
        <source>Tag as wall</source>
        <translation>添加墙标签</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>显示</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Remove broken shapes</source>
        <translation>移除损坏的形状</translation>
    </message>
    <message>
        <source>Untangle outline</source>
        <translation>理顺轮廓</translation>
    </message>
    <message>
        <source>Move to a free place</source>
        <translation>移到空位</translation>
    </message>
    <message>
        <source>Fix all safe problems</source>
        <translation>修复所有安全的问题</translation>
    </message>
    <message>
        <source>Hide problem</source>
        <translation>隐藏问题</translation>
    </message>
    <message>
        <source>Show hidden problem</source>
        <translation>显示已隐藏的问题</translation>
    </message>
    <message>
        <source>Reverse object</source>
        <translation>反转对象</translation>
    </message>
    <message numerus="yes">
        <source>Reverse %n objects</source>
        <translation>
            <numerusform>反转 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Take over object</source>
        <translation>采用对象</translation>
    </message>
    <message numerus="yes">
        <source>Take over %n objects</source>
        <translation>
            <numerusform>采用 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>删除对象</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n objects</source>
        <translation>
            <numerusform>删除 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>移动节点</translation>
    </message>
    <message numerus="yes">
        <source>Move %n nodes</source>
        <translation>
            <numerusform>移动 %n 个节点</numerusform>
        </translation>
    </message>
    <message>
        <source>Rotate nodes</source>
        <translation>旋转节点</translation>
    </message>
    <message numerus="yes">
        <source>Rotate %n nodes</source>
        <translation>
            <numerusform>旋转 %n 个节点</numerusform>
        </translation>
    </message>
    <message>
        <source>Scale nodes</source>
        <translation>缩放节点</translation>
    </message>
    <message numerus="yes">
        <source>Scale %n nodes</source>
        <translation>
            <numerusform>缩放 %n 个节点</numerusform>
        </translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>插入节点</translation>
    </message>
    <message>
        <source>Delete node</source>
        <translation>删除节点</translation>
    </message>
    <message numerus="yes">
        <source>Delete %n nodes</source>
        <translation>
            <numerusform>删除 %n 个节点</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>删除线段</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>连接节点</translation>
    </message>
    <message>
        <source>Break at node</source>
        <translation>在节点处断开</translation>
    </message>
    <message numerus="yes">
        <source>Break at %n nodes</source>
        <translation>
            <numerusform>在 %n 个节点处断开</numerusform>
        </translation>
    </message>
    <message>
        <source>Reverse part</source>
        <translation>反转部分</translation>
    </message>
    <message>
        <source>Straighten segments</source>
        <translation>拉直线段</translation>
    </message>
    <message>
        <source>Cut with the knife</source>
        <translation>用切刀切割</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>创建对象副本</translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n objects</source>
        <translation>
            <numerusform>创建 %n 个对象的副本</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut object</source>
        <translation>剪切对象</translation>
    </message>
    <message numerus="yes">
        <source>Cut %n objects</source>
        <translation>
            <numerusform>剪切 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>更改对象</translation>
    </message>
    <message numerus="yes">
        <source>Change %n objects</source>
        <translation>
            <numerusform>更改 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Change level</source>
        <translation>更改关卡</translation>
    </message>
    <message>
        <source>Change who touches whom</source>
        <translation>更改接触关系</translation>
    </message>
    <message>
        <source>Change tag</source>
        <translation>更改标签</translation>
    </message>
    <message>
        <source>Paste object</source>
        <translation>粘贴对象</translation>
    </message>
    <message numerus="yes">
        <source>Paste %n objects</source>
        <translation>
            <numerusform>粘贴 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Reload from disk</source>
        <translation>从磁盘重新加载</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>恢复未保存的工作</translation>
    </message>
    <message>
        <source>Open backup</source>
        <translation>打开备份</translation>
    </message>
    <message>
        <source>Import object</source>
        <translation>导入对象</translation>
    </message>
    <message numerus="yes">
        <source>Import %n objects</source>
        <translation>
            <numerusform>导入 %n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>Add guide</source>
        <translation>添加参考线</translation>
    </message>
    <message>
        <source>Change guide</source>
        <translation>更改参考线</translation>
    </message>
    <message>
        <source>Delete guide</source>
        <translation>删除参考线</translation>
    </message>
    <message>
        <source>Delete all guides</source>
        <translation>删除所有参考线</translation>
    </message>
    <message>
        <source>The file “%1” cannot be read: %2.</source>
        <translation>无法读取文件“%1”：%2。</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: %2. What was there before is still there.</source>
        <translation>无法写入文件“%1”：%2。原有内容仍然保留。</translation>
    </message>
    <message>
        <source>The disk is full, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>磁盘已满，无法写入文件“%1”。原有内容仍然保留。</translation>
    </message>
    <message>
        <source>You have used up your share of the disk, so the file “%1” cannot be written. What was there before is still there.</source>
        <translation>您的磁盘配额已用完，无法写入文件“%1”。原有内容仍然保留。</translation>
    </message>
    <message>
        <source>The disk with the file “%1” can only be read, so it cannot be written.</source>
        <translation>文件“%1”所在的磁盘为只读，无法写入。</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: there is no folder “%2” any more.</source>
        <translation>无法写入文件“%1”：文件夹“%2”已不存在。</translation>
    </message>
    <message>
        <source>The file “%1” cannot be written: you may not make files in the folder “%2”.</source>
        <translation>无法写入文件“%1”：您无权在文件夹“%2”中创建文件。</translation>
    </message>
    <message>
        <source>The file “%1” is protected: you may read it, but not write it.</source>
        <translation>文件“%1”受保护：您可以读取，但不能写入。</translation>
    </message>
    <message>
        <source>The file “%1” has been changed by somebody else meanwhile, so it was not overwritten.</source>
        <translation>文件“%1”期间已被他人更改，因此未覆盖。</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. What was there before is lost; save it elsewhere.</source>
        <translation>文件“%1”仅写入了一部分：%2。原有内容已丢失；请保存到别处。</translation>
    </message>
    <message>
        <source>The file “%1” was written in part only: %2. All that it was to hold is in the file “%3”.</source>
        <translation>文件“%1”仅写入了一部分：%2。应写入的全部内容在文件“%3”中。</translation>
    </message>
    <message>
        <source>“%1” is not a finite number, and a file cannot hold it.</source>
        <translation>“%1”不是有限数，文件无法保存。</translation>
    </message>
    <message>
        <source>“%1” is %2; it must lie between %3 and %4.</source>
        <translation>“%1”为 %2；必须介于 %3 和 %4 之间。</translation>
    </message>
    <message>
        <source>The mass is too small or too large to be computed with, so the body would be missing from the game.</source>
        <translation>质量过小或过大，无法计算，因此物体不会出现在游戏中。</translation>
    </message>
    <message>
        <source>The body is so small and light, or so large and heavy, that its mass or inertia cannot be computed with. It would be missing from the game.</source>
        <translation>物体太小太轻或太大太重，无法计算其质量或转动惯量，因此不会出现在游戏中。</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be more than zero.</source>
        <translation>“%1”为 %2；必须大于零。</translation>
    </message>
    <message>
        <source>Select at least two bodies made of polygons, not locked.</source>
        <translation>请选择至少两个由多边形组成且未锁定的物体。</translation>
    </message>
    <message>
        <source>“%1” is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>“%1”不是只由多边形组成。只有多边形可以求并集、差集和交集。</translation>
    </message>
    <message>
        <source>These bodies lie too far from the origin to be combined: at most 500 km.</source>
        <translation>这些物体离原点太远，无法组合：最远 500 km。</translation>
    </message>
    <message>
        <source>Nothing would be left of these bodies, so they stay as they are.</source>
        <translation>这些物体将一点不剩，因此保持原样。</translation>
    </message>
    <message>
        <source>The result would cross itself, so the bodies stay as they are. Move one of them a little and try again.</source>
        <translation>结果会自交，因此物体保持原样。请稍微移动其中一个再试。</translation>
    </message>
    <message>
        <source>The file starts with a byte order mark, which saving will leave out.</source>
        <translation>文件以字节顺序标记 (BOM) 开头，保存时会略去。</translation>
    </message>
    <message>
        <source>“%1” is not expected here: something is wrong at this place or just before it.</source>
        <translation>此处不应出现“%1”：此处或其前方有错误。</translation>
    </message>
    <message>
        <source>A text is not closed with a quotation mark before its line ends.</source>
        <translation>文本在行尾之前没有以引号闭合。</translation>
    </message>
    <message>
        <source>The control character %1 cannot stand here as it is.</source>
        <translation>控制字符 %1 不能直接写在此处。</translation>
    </message>
    <message>
        <source>“%1” is not a number that a file can hold; write a finite one.</source>
        <translation>“%1”不是文件可以保存的数字；请写有限数。</translation>
    </message>
    <message>
        <source>There is a comma before “%1” that nothing follows; leave it out.</source>
        <translation>“%1”前有一个多余的逗号；请删去。</translation>
    </message>
    <message>
        <source>The number %1 is larger than any that can be computed with.</source>
        <translation>数字 %1 超出了可计算的范围。</translation>
    </message>
    <message>
        <source>Lists and objects lie more than %1 deep in one another.</source>
        <translation>列表和对象的嵌套超过 %1 层。</translation>
    </message>
    <message>
        <source>The file holds more than %1 values.</source>
        <translation>文件包含的值超过 %1 个。</translation>
    </message>
    <message>
        <source>The level is so large that it could not be saved again, so it is not opened.</source>
        <translation>关卡过大，将无法再次保存，因此不打开。</translation>
    </message>
    <message>
        <source>The file holds more than %1 vertices.</source>
        <translation>文件包含的顶点超过 %1 个。</translation>
    </message>
    <message>
        <source>The field “%1” is given twice.</source>
        <translation>字段“%1”出现了两次。</translation>
    </message>
    <message>
        <source>This is not a level: it should be an object in braces, but is %1.</source>
        <translation>这不是关卡：应为花括号中的对象，实际是 %1。</translation>
    </message>
    <message>
        <source>This is not a level: the field “schema” is missing (it should be %1).</source>
        <translation>这不是关卡：缺少字段“schema”（应为 %1）。</translation>
    </message>
    <message>
        <source>The level was made with a newer version (schema %1; this one reads up to %2). Please update the program.</source>
        <translation>关卡由更新版本制作（格式版本 %1；本程序最高支持 %2）。请更新程序。</translation>
    </message>
    <message>
        <source>The schema %1 is not known; this version reads %2.</source>
        <translation>未知的格式版本 %1；本程序读取 %2。</translation>
    </message>
    <message>
        <source>The field “%1” is missing.</source>
        <translation>缺少字段“%1”。</translation>
    </message>
    <message>
        <source>The field “%1” is not known here. It is kept, but does nothing.</source>
        <translation>此处不认识字段“%1”。它会保留，但不起作用。</translation>
    </message>
    <message>
        <source>“%1” must be a number, not %2.</source>
        <translation>“%1”必须是数字，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be a whole number, not %2.</source>
        <translation>“%1”必须是整数，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be a number, or null for a wall without a back, not %2.</source>
        <translation>“%1”必须是数字（墙无背面时为 null），而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be true or false, not %2.</source>
        <translation>“%1”必须是 true 或 false，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be a text, not %2.</source>
        <translation>“%1”必须是文本，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be two numbers [x, y], not %2.</source>
        <translation>“%1”必须是两个数字 [x, y]，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be a list in brackets, not %2.</source>
        <translation>“%1”必须是方括号中的列表，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must hold objects in braces, not %2.</source>
        <translation>“%1”必须包含花括号中的对象，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” must be “all”, a list of tags or {&quot;except&quot;: a list of tags}, not %2.</source>
        <translation>“%1”必须是“all”、标签列表或 {&quot;except&quot;: 标签列表}，而不是 %2。</translation>
    </message>
    <message>
        <source>“%1” is %2; it must be one of: %3.</source>
        <translation>“%1”为 %2；必须是以下之一：%3。</translation>
    </message>
    <message>
        <source>There is no tag named “%1” in this level.</source>
        <translation>此关卡中没有名为“%1”的标签。</translation>
    </message>
    <message>
        <source>“%1” must be eight hexadecimal digits that are not all zero, not %2.</source>
        <translation>“%1”必须是八位不全为零的十六进制数字，而不是 %2。</translation>
    </message>
    <message>
        <source>The key %1 is taken by the object in line %2.</source>
        <translation>标识 %1 已被第 %2 行的对象占用。</translation>
    </message>
    <message>
        <source>The key %1 is taken by another object.</source>
        <translation>标识 %1 已被另一个对象占用。</translation>
    </message>
    <message>
        <source>There are two tags named “%1”.</source>
        <translation>有两个名为“%1”的标签。</translation>
    </message>
    <message>
        <source>There are two tags with the index %1.</source>
        <translation>有两个索引为 %1 的标签。</translation>
    </message>
    <message>
        <source>“%1” must be a whole number from 0 to 31, not %2.</source>
        <translation>“%1”必须是 0 到 31 的整数，而不是 %2。</translation>
    </message>
    <message>
        <source>A tag cannot be named “%1”: that is how a tag without a name is written.</source>
        <translation>标签不能命名为“%1”：这是无名标签的写法。</translation>
    </message>
    <message>
        <source>“%1” must be a color such as &quot;#4cc9f0&quot;, not %2.</source>
        <translation>“%1”必须是颜色，例如 &quot;#4cc9f0&quot;，而不是 %2。</translation>
    </message>
    <message>
        <source>There are %1 more problems, which are not listed.</source>
        <translation>还有 %1 个问题未列出。</translation>
    </message>
    <message>
        <source>The level has no ship. Place one, or remove payload and finish to make it a sandbox.</source>
        <translation>关卡没有飞船。请放置飞船，或移除载荷和终点使其成为沙盒。</translation>
    </message>
    <message>
        <source>The level has no payload. Place one, or remove ship and finish to make it a sandbox.</source>
        <translation>关卡没有载荷。请放置载荷，或移除飞船和终点使其成为沙盒。</translation>
    </message>
    <message>
        <source>The level has no finish. Place one, or remove ship and payload to make it a sandbox.</source>
        <translation>关卡没有终点。请放置终点，或移除飞船和载荷使其成为沙盒。</translation>
    </message>
    <message>
        <source>There is more than one ship; only the first flies.</source>
        <translation>飞船不止一艘；只有第一艘会飞。</translation>
    </message>
    <message>
        <source>There is more than one payload; only the first counts.</source>
        <translation>载荷不止一个；只有第一个有效。</translation>
    </message>
    <message>
        <source>There is more than one finish; only the first counts.</source>
        <translation>终点不止一个；只有第一个有效。</translation>
    </message>
    <message>
        <source>The ship starts in touch with the object “%1” and would crash at once.</source>
        <translation>飞船起始时接触对象“%1”，会立即坠毁。</translation>
    </message>
    <message>
        <source>The payload starts in touch with the object “%1”.</source>
        <translation>载荷起始时接触对象“%1”。</translation>
    </message>
    <message>
        <source>The ship starts in touch with %2 at %3; %4 m and would crash at once.</source>
        <translation>飞船起始时接触 %3; %4 m 处的%2，会立即坠毁。</translation>
    </message>
    <message>
        <source>The payload starts in touch with %2 at %3; %4 m.</source>
        <translation>载荷起始时接触 %3; %4 m 处的%2。</translation>
    </message>
    <message>
        <source>the one-way wall</source>
        <translation>单向墙</translation>
    </message>
    <message>
        <source>the two-way line</source>
        <translation>双向线</translation>
    </message>
    <message>
        <source>the polygon</source>
        <translation>多边形</translation>
    </message>
    <message>
        <source>the circle</source>
        <translation>圆</translation>
    </message>
    <message>
        <source>the body</source>
        <translation>物体</translation>
    </message>
    <message>
        <source>The body has no shape.</source>
        <translation>物体没有形状。</translation>
    </message>
    <message>
        <source>A chain of walls needs at least two vertices; this one has %1.</source>
        <translation>墙链至少需要两个顶点；此链有 %1 个。</translation>
    </message>
    <message>
        <source>All vertices of this chain of walls lie at the same point.</source>
        <translation>此墙链的所有顶点都在同一点。</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 lie at the same point: the wall between them has no length.</source>
        <translation>顶点 %1 和 %2 在同一点：其间的墙没有长度。</translation>
    </message>
    <message>
        <source>Vertices %1 and %2 of the polygon lie at the same point.</source>
        <translation>多边形的顶点 %1 和 %2 在同一点。</translation>
    </message>
    <message>
        <source>A polygon of %1 vertices is too large; %2 are allowed.</source>
        <translation>多边形有 %1 个顶点，过大；最多允许 %2 个。</translation>
    </message>
    <message>
        <source>A polygon needs at least three different vertices; this one has %1.</source>
        <translation>多边形至少需要三个不同的顶点；此多边形有 %1 个。</translation>
    </message>
    <message>
        <source>The polygon crosses itself: the sides from vertex %1 and from vertex %2 meet.</source>
        <translation>多边形自交：始于顶点 %1 和始于顶点 %2 的边相交。</translation>
    </message>
    <message>
        <source>The polygon crosses itself.</source>
        <translation>多边形自交。</translation>
    </message>
    <message>
        <source>All vertices of the polygon lie on one line: it encloses nothing.</source>
        <translation>多边形的所有顶点在一条直线上：没有围住任何区域。</translation>
    </message>
    <message>
        <source>The vertices of the polygon run clockwise; they are taken the other way round.</source>
        <translation>多边形的顶点为顺时针；将按相反方向读取。</translation>
    </message>
    <message>
        <source>It belongs to the group %1, which does not exist; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>该对象属于不存在的组 %1；显示在顶层。请放入另一个组或移到顶层。</translation>
    </message>
    <message>
        <source>It belongs to the object %1, which is not a group; it is shown at the top. Put it into another group, or to the top.</source>
        <translation>该对象属于对象 %1，而它不是组；显示在顶层。请放入另一个组或移到顶层。</translation>
    </message>
    <message>
        <source>It is in the group %1, which is in it, directly or not; it is shown at the top. Put one of them to the top.</source>
        <translation>该对象在组 %1 中，而该组又直接或间接在该对象中；显示在顶层。请把其中之一移到顶层。</translation>
    </message>
    <message>
        <source>A layer is in another group. Layers are at the top: put it there, or make it an ordinary group.</source>
        <translation>图层位于另一个组中。图层应在顶层：请移到顶层，或改为普通组。</translation>
    </message>
    <message>
        <source>It is hidden in the editor, but takes part in the game.</source>
        <translation>该对象在编辑器中隐藏，但会参与游戏。</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which does not exist.</source>
        <translation>连接件的“%1”端是不存在的对象 %2。</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is the object %2, which is not a body.</source>
        <translation>连接件的“%1”端是对象 %2，而它不是物体。</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same object.</source>
        <translation>连接件的两端在同一对象上。</translation>
    </message>
    <message>
        <source>A stiffness of %1 N/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>对当前子步数而言，刚度 %1 N/m 过大：弹簧可能抖动。约需 %2 个子步。</translation>
    </message>
    <message>
        <source>A damping of %1 N s/m is too much for the sub-steps: the spring may shake. About %2 sub-steps would do.</source>
        <translation>对当前子步数而言，阻尼 %1 N s/m 过大：弹簧可能抖动。约需 %2 个子步。</translation>
    </message>
    <message>
        <source>The tags of this body are such that nothing can touch it.</source>
        <translation>按此物体的标签，没有任何东西能接触它。</translation>
    </message>
    <message>
        <source>Points that lie on straight sides and do nothing: %1.</source>
        <translation>直边上不起作用的点：%1。</translation>
    </message>
    <message>
        <source>This wall is solid on the other side than the walls it goes on from: the ship can fly out through it. Reverse it.</source>
        <translation>此墙的实心侧与所接的墙相反：飞船可以从中飞出。请反转此墙。</translation>
    </message>
    <message>
        <source>This wall and the one it goes on from are solid on different sides. Reverse one of them.</source>
        <translation>此墙与所接的墙实心侧不同。请反转其中之一。</translation>
    </message>
    <message>
        <source>The two ends of this chain of walls are %1 mm apart, so it is not closed.</source>
        <translation>此墙链的两端相距 %1 mm，因此没有闭合。</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to “%1”.</source>
        <translation>与“%1”之间有 %5 mm 的缺口。</translation>
    </message>
    <message>
        <source>There is a gap of %5 mm to %2 at %3; %4 m.</source>
        <translation>与 %3; %4 m 处的%2之间有 %5 mm 的缺口。</translation>
    </message>
    <message>
        <source>This wall lies exactly on “%1”, which does the same.</source>
        <translation>此墙与作用相同的“%1”完全重合。</translation>
    </message>
    <message>
        <source>This wall lies exactly on %2 at %3; %4 m, which does the same.</source>
        <translation>此墙与 %3; %4 m 处作用相同的%2完全重合。</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of “%1”: %5.</source>
        <translation>与“%1”的墙完全重合的墙：%5。</translation>
    </message>
    <message>
        <source>Walls that lie exactly on those of %2 at %3; %4 m: %5.</source>
        <translation>与 %3; %4 m 处的%2的墙完全重合的墙：%5。</translation>
    </message>
    <message>
        <source>Walls that lie exactly on others of the same chain: %1.</source>
        <translation>与同一链的其他墙完全重合的墙：%1。</translation>
    </message>
    <message>
        <source>It lies exactly on “%1”, which is the same.</source>
        <translation>该对象与相同的“%1”完全重合。</translation>
    </message>
    <message>
        <source>It lies exactly on %2 at %3; %4 m, which is the same.</source>
        <translation>该对象与 %3; %4 m 处相同的%2完全重合。</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but what is fastest here may move %2 m between two looks at what it touches, and may get through. Make it deeper, or raise the iterations.</source>
        <translation>墙深 %1 m，但此处最快的物体在两次接触检查之间可能移动 %2 m，从而穿过墙。请加大深度，或增加迭代次数。</translation>
    </message>
    <message>
        <source>The wall has no back, so what is solid behind it reaches into the free space %1 m behind. Give it a depth of no more than that.</source>
        <translation>墙没有背面，因此墙后的实心部分伸入后方 %1 m 处的自由空间。请设定不超过此值的深度。</translation>
    </message>
    <message>
        <source>The wall is %1 m deep, but %2 m behind it there is free space, into which it reaches. Give it a depth of no more than that.</source>
        <translation>墙深 %1 m，但其后 %2 m 处是自由空间，墙会伸入其中。请设定不超过此值的深度。</translation>
    </message>
    <message>
        <source>The wall has no back, so all the free space behind it counts as solid. Give it a depth.</source>
        <translation>墙没有背面，因此其后的自由空间全部算作实心。请设定深度。</translation>
    </message>
    <message>
        <source>The ship starts outside of the cave that the payload is in.</source>
        <translation>飞船的起始位置在载荷所在的洞穴之外。</translation>
    </message>
    <message>
        <source>The payload is outside of the cave that the ship starts in.</source>
        <translation>载荷在飞船起始的洞穴之外。</translation>
    </message>
    <message>
        <source>The finish is outside of the cave that the ship starts in.</source>
        <translation>终点在飞船起始的洞穴之外。</translation>
    </message>
    <message>
        <source>Both ends of the finish lie at the same point, so nothing can cross it.</source>
        <translation>终点线的两端在同一点，因此无法越过。</translation>
    </message>
    <message>
        <source>The payload starts on the finish.</source>
        <translation>载荷的起始位置在终点线上。</translation>
    </message>
    <message>
        <source>Gravity is too strong: the ship weighs %1 N, and its thrust is %2 N.</source>
        <translation>重力过强：飞船重 %1 N，而推力为 %2 N。</translation>
    </message>
    <message>
        <source>Ship and payload together weigh %1 N; the ship&apos;s thrust of %2 N cannot lift them.</source>
        <translation>飞船和载荷共重 %1 N；飞船 %2 N 的推力无法提起。</translation>
    </message>
    <message>
        <source>There is no background named “%1”; it is shown as a plain one.</source>
        <translation>没有名为“%1”的背景；显示为纯色背景。</translation>
    </message>
    <message>
        <source>The ship flies through this wall: it does not have the tag “%1”.</source>
        <translation>飞船会穿过此墙：此墙没有标签“%1”。</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through “%1”.</source>
        <translation>该物体只由墙组成，而墙与墙从不相碰：它会从“%1”中穿落。</translation>
    </message>
    <message>
        <source>It is made of walls alone, and walls never meet walls: it falls through %2 at %3; %4 m.</source>
        <translation>该物体只由墙组成，而墙与墙从不相碰：它会从 %3; %4 m 处的%2中穿落。</translation>
    </message>
    <message>
        <source>The ship can get out through this wall: it is solid on the wrong side. Reverse it.</source>
        <translation>飞船可以穿过此墙飞出：它的实心面反了。请将其反向。</translation>
    </message>
    <message>
        <source>The ship can get out through this chain: all its %1 walls are solid on the wrong side. Reverse it.</source>
        <translation>飞船可以穿过此链飞出：它的 %1 面墙实心面都反了。请将其反向。</translation>
    </message>
    <message>
        <source>The ship can get out through edge %1 of this chain: it is solid on the wrong side.</source>
        <translation>飞船可以穿过此链的第 %1 条边飞出：它的实心面反了。</translation>
    </message>
    <message>
        <source>The ship can get out: %1 walls, of which this is one, are solid on the wrong side.</source>
        <translation>飞船可以飞出：包括此墙在内的 %1 面墙实心面反了。</translation>
    </message>
    <message>
        <source>The ship can get out: this chain is not closed, its ends are %1 m apart.</source>
        <translation>飞船可以飞出：此链没有闭合，两端相距 %1 m。</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %1 m is missing between two ends of this object.</source>
        <translation>飞船可以飞出：此对象的两端之间缺少一面 %1 m 的墙。</translation>
    </message>
    <message>
        <source>The ship can get out: there is an opening of %1 m in this object.</source>
        <translation>飞船可以飞出：此对象有一个 %1 m 的开口。</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of “%1”.</source>
        <translation>飞船可以飞出：此对象的端点与“%1”的端点之间缺少一面 %5 m 的墙。</translation>
    </message>
    <message>
        <source>The ship can get out: a wall of %5 m is missing between the end of this one and that of %2 at %3; %4 m.</source>
        <translation>飞船可以飞出：此对象的端点与 %3; %4 m 处的%2的端点之间缺少一面 %5 m 的墙。</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before “%1”.</source>
        <translation>飞船可以飞出：此墙在距“%1” %5 m 处中断。</translation>
    </message>
    <message>
        <source>The ship can get out: this wall ends %5 m before %2 at %3; %4 m.</source>
        <translation>飞船可以飞出：此墙在距 %3; %4 m 处的%2 %5 m 处中断。</translation>
    </message>
    <message>
        <source>The ship can get out between this and “%1”: they are %5 m apart.</source>
        <translation>飞船可以从此对象与“%1”之间飞出：两者相距 %5 m。</translation>
    </message>
    <message>
        <source>The ship can get out between this and %2 at %3; %4 m: they are %5 m apart.</source>
        <translation>飞船可以从此对象与 %3; %4 m 处的%2之间飞出：两者相距 %5 m。</translation>
    </message>
    <message>
        <source>“%1” is not a mass that a body can have.</source>
        <translation>“%1”不是物体可有的质量。</translation>
    </message>
    <message>
        <source>The body has a shape that cannot be simulated.</source>
        <translation>物体的形状无法模拟。</translation>
    </message>
    <message>
        <source>The end “%1” of the connector is not in the world.</source>
        <translation>连接件的“%1”端不在世界中。</translation>
    </message>
    <message>
        <source>Both ends of the connector are on the same body.</source>
        <translation>连接件的两端在同一物体上。</translation>
    </message>
    <message>
        <source>These tags came along, as the level did not have them: %1.</source>
        <translation>关卡原本没有这些标签，已一并加入：%1。</translation>
    </message>
    <message>
        <source>The tag “%1” is called “%2” in this level.</source>
        <translation>标签“%1”在此关卡中名为“%2”。</translation>
    </message>
    <message>
        <source>All 32 tags of this level are in use, so these were left off: %1.</source>
        <translation>此关卡的 32 个标签均已占用，因此略去：%1。</translation>
    </message>
    <message>
        <source>A number is missing.</source>
        <translation>缺少数字。</translation>
    </message>
    <message>
        <source>Something is missing at the end.</source>
        <translation>末尾缺少内容。</translation>
    </message>
    <message>
        <source>“%1” cannot stand where it is.</source>
        <translation>“%1”不能出现在此处。</translation>
    </message>
    <message>
        <source>“%1” is neither a unit nor a function; try 2*pi/3, sqrt(2), 20 cm or +=0.5.</source>
        <translation>“%1”既不是单位也不是函数；请试用 2*pi/3、sqrt(2)、20 cm 或 +=0.5。</translation>
    </message>
    <message>
        <source>A parenthesis is not closed.</source>
        <translation>有括号未闭合。</translation>
    </message>
    <message>
        <source>“%1” has another number of values; they are parted by semicolons.</source>
        <translation>“%1”的值数量不同；各值以分号分隔。</translation>
    </message>
    <message>
        <source>This is too long or too deeply nested.</source>
        <translation>内容过长或嵌套过深。</translation>
    </message>
    <message>
        <source>Nothing can be divided by zero.</source>
        <translation>任何数都不能除以零。</translation>
    </message>
    <message>
        <source>The result is too large, or is no number.</source>
        <translation>结果过大，或不是数字。</translation>
    </message>
    <message>
        <source>These units do not go together.</source>
        <translation>这些单位不能一起使用。</translation>
    </message>
    <message>
        <source>The result must be a plain number or one in %1.</source>
        <translation>结果必须是纯数字或以 %1 为单位的数。</translation>
    </message>
    <message>
        <source>This is a plain number without a unit.</source>
        <translation>这是没有单位的纯数字。</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>顶点</translation>
    </message>
    <message>
        <source>vertex of %1</source>
        <translation>%1 的顶点</translation>
    </message>
    <message>
        <source>center</source>
        <translation>中心</translation>
    </message>
    <message>
        <source>center of %1</source>
        <translation>%1 的中心</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>锚点</translation>
    </message>
    <message>
        <source>anchor on %1</source>
        <translation>%1 上的锚点</translation>
    </message>
    <message>
        <source>intersection</source>
        <translation>交点</translation>
    </message>
    <message>
        <source>intersection with %1</source>
        <translation>与 %1 的交点</translation>
    </message>
    <message>
        <source>midpoint</source>
        <translation>中点</translation>
    </message>
    <message>
        <source>midpoint of %1</source>
        <translation>%1 的中点</translation>
    </message>
    <message>
        <source>perpendicular</source>
        <translation>垂足</translation>
    </message>
    <message>
        <source>perpendicular to %1</source>
        <translation>%1 上的垂足</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>边</translation>
    </message>
    <message>
        <source>edge of %1</source>
        <translation>%1 的边</translation>
    </message>
    <message>
        <source>guide</source>
        <translation>参考线</translation>
    </message>
    <message>
        <source>guide %1</source>
        <translation>参考线 %1</translation>
    </message>
    <message>
        <source>aligned</source>
        <translation>对齐</translation>
    </message>
    <message>
        <source>in line with %1</source>
        <translation>与 %1 对齐</translation>
    </message>
    <message>
        <source>multiple of 15°</source>
        <translation>15° 的倍数</translation>
    </message>
    <message>
        <source>grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 和 %2</translation>
    </message>
    <message>
        <source>once</source>
        <translation>一次</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n 次</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, in line %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>%1, in lines %2</source>
        <translation>%1，第 %2 行</translation>
    </message>
    <message>
        <source>What drawings within the drawing hide beyond their borders is there as well (%4).</source>
        <translation>图中之图在其边界之外隐藏的内容也一并导入（%4）。</translation>
    </message>
    <message>
        <source>The width of wide strokes was not taken over: they are walls without thickness (%4). “Stroke to Path” of Inkscape makes areas of them.</source>
        <translation>未采用宽描边的宽度：它们是没有厚度的墙（%4）。Inkscape 的“描边转路径”可将其变成区域。</translation>
    </message>
    <message>
        <source>They touch: “%1” and “%2” are in contact.</source>
        <translation>它们互相接触：“%1”与“%2”已接触。</translation>
    </message>
    <message>
        <source>Both are the same body, which does not collide with itself.</source>
        <translation>两者是同一个物体，不会与自身碰撞。</translation>
    </message>
    <message>
        <source>“%1” is switched off, so it touches nothing.</source>
        <translation>“%1”已关闭，因此不接触任何东西。</translation>
    </message>
    <message>
        <source>Neither is moved by forces: “%1” and “%2” pass through each other unless one of them is dynamic.</source>
        <translation>两者都不受力的作用：除非其中之一为动态，否则“%1”和“%2”会互相穿过。</translation>
    </message>
    <message>
        <source>“%2” has no tags, and what has none is touched by nothing.</source>
        <translation>“%2”没有标签，而没有标签的对象不会被任何东西接触。</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3.</source>
        <translation>“%1”不接触“%2”所属的类别：%3。</translation>
    </message>
    <message>
        <source>“%1” does not touch what “%2” is: %3. Nor does “%2” touch what “%1” is.</source>
        <translation>“%1”不接触“%2”所属的类别：%3。“%2”也不接触“%1”所属的类别。</translation>
    </message>
    <message>
        <source>“%3” connects “%1” and “%2”, and bodies that it connects do not collide.</source>
        <translation>“%3”连接着“%1”和“%2”，而它所连接的物体不会碰撞。</translation>
    </message>
    <message>
        <source>The tow rope connects “%1” and “%2”, which therefore do not collide.</source>
        <translation>拖绳连接着“%1”和“%2”，因此它们不会碰撞。</translation>
    </message>
    <message>
        <source>“%1” is intangible: it would be felt, but stops nothing.</source>
        <translation>“%1”是无形的：能被感知，但挡不住任何东西。</translation>
    </message>
    <message>
        <source>“%1” is intangible: “%2” touches it and is felt, but nothing stops it.</source>
        <translation>“%1”是无形的：“%2”接触它并会被感知，但不会被挡住。</translation>
    </message>
    <message>
        <source>Both are nothing but walls, and walls pass through each other.</source>
        <translation>两者都只是墙，而墙会互相穿过。</translation>
    </message>
    <message>
        <source>“%1” and “%2” may collide, but are %3 m apart.</source>
        <translation>“%1”和“%2”可以碰撞，但相距 %3 m。</translation>
    </message>
    <message>
        <source>“%1” and “%2” overlap, and collide as soon as the simulation goes on.</source>
        <translation>“%1”和“%2”重叠，模拟一继续就会碰撞。</translation>
    </message>
    <message>
        <source>Let “%1” touch “%2”</source>
        <translation>让“%1”接触“%2”</translation>
    </message>
    <message>
        <source>Give “%1” the tag “%2”</source>
        <translation>给“%1”添加标签“%2”</translation>
    </message>
    <message>
        <source>Make “%1” tangible</source>
        <translation>使“%1”变为有形</translation>
    </message>
    <message>
        <source>Let the bodies of “%1” collide</source>
        <translation>让“%1”两端的物体碰撞</translation>
    </message>
    <message>
        <source>Back to before the run</source>
        <translation>回到运行之前</translation>
    </message>
    <message>
        <source>Keep change of the level</source>
        <translation>保留关卡的更改</translation>
    </message>
    <message>
        <source>Keep new object</source>
        <translation>保留新对象</translation>
    </message>
    <message>
        <source>Keep deletion</source>
        <translation>保留删除</translation>
    </message>
    <message>
        <source>Keep move</source>
        <translation>保留移动</translation>
    </message>
    <message>
        <source>Keep tags</source>
        <translation>保留标签</translation>
    </message>
    <message>
        <source>Keep order</source>
        <translation>保留次序</translation>
    </message>
    <message>
        <source>Keep change</source>
        <translation>保留更改</translation>
    </message>
    <message>
        <source>There is no bug capsule in the text.</source>
        <translation>文本中没有错误胶囊。</translation>
    </message>
    <message>
        <source>The bug capsule was made with a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>错误胶囊由更新版本制作（%1；本程序最高支持 %2）。请更新程序。</translation>
    </message>
    <message>
        <source>The run is longer than a bug capsule may be: %1 updates.</source>
        <translation>这次运行超出了错误胶囊的长度限制：%1 个时间步。</translation>
    </message>
    <message>
        <source>The run has ended, and nothing of it is left.</source>
        <translation>运行已结束，没有留下任何内容。</translation>
    </message>
    <message>
        <source>Edits of the run</source>
        <translation>运行中的编辑</translation>
    </message>
    <message numerus="yes">
        <source>Keep %n changes</source>
        <translation>
            <numerusform>保留 %n 处更改</numerusform>
        </translation>
    </message>
    <message>
        <source>The wall is solid inside, where ship or payload start: it was drawn clockwise. Reverse it to make a cave of the rock.</source>
        <translation>墙的内侧是实心的，而飞船或货物从那里出发：它是顺时针绘制的。请将其反转，使岩石变成洞穴。</translation>
    </message>
    <message>
        <source>%1 cannot be opened.</source>
        <translation>无法打开 %1。</translation>
    </message>
    <message>
        <source>The file is not sound XML: line %1, column %2: %3</source>
        <translation>文件不是有效的 XML：第 %1 行第 %2 列：%3</translation>
    </message>
    <message>
        <source>Elements of the file lie more than %1 deep in one another. Ungroup some of them, and try again.</source>
        <translation>文件中的元素嵌套超过 %1 层。请取消一些组合后重试。</translation>
    </message>
    <message>
        <source>The file draws more than %1 pieces, which is more than can be imported. Take out what the level does not need, and try again.</source>
        <translation>文件绘制了超过 %1 个图形，超出可导入的数量。请去掉关卡不需要的内容后重试。</translation>
    </message>
    <message>
        <source>Drag: move · Shift + drag: move the pivot, about which it turns</source>
        <translation>拖动：移动 · Shift + 拖动：移动旋转中心</translation>
    </message>
    <message>
        <source>The file “%1” is too large: at most %2 can be read.</source>
        <translation>文件“%1”过大：最多可读取 %2。</translation>
    </message>
    <message>
        <source>This is too large: at most %1 can be read.</source>
        <translation>内容过大：最多可读取 %1。</translation>
    </message>
    <message>
        <source>The file is empty. Fetch it again, or take a copy of it from a backup.</source>
        <translation>文件为空。请重新获取，或使用备份中的副本。</translation>
    </message>
    <message>
        <source>The file is not text in UTF-8 from here on: it is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>从此处起文件不是 UTF-8 文本：它已损坏或是其他类型的文件。请重新获取，或使用备份中的副本。</translation>
    </message>
    <message>
        <source>There is a zero byte here, which text cannot hold: the file is damaged, or something else. Fetch it again, or take a copy of it from a backup.</source>
        <translation>此处有一个零字节，文本中不能包含它：文件已损坏或是其他类型的文件。请重新获取，或使用备份中的副本。</translation>
    </message>
    <message>
        <source>The file ends too early: a bracket, a brace or a quotation mark is not closed. Perhaps it was not copied as a whole; fetch it again.</source>
        <translation>文件过早结束：有括号、花括号或引号没有闭合。文件可能没有完整复制；请重新获取。</translation>
    </message>
    <message>
        <source>Neither of the two bodies can be moved by the connector; one should be dynamic.</source>
        <translation>连接件无法移动这两个物体中的任何一个；其中一个应为动态。</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>第 %1 行：%2</translation>
    </message>
    <message>
        <source>This is not a recorded flight. “Save Flight…” makes one of a run.</source>
        <translation>这不是录制的飞行。“保存飞行…”可由一次运行生成。</translation>
    </message>
    <message>
        <source>Line %2: “%1” is missing or not what a recorded flight has there. Correct it in a text editor, or save the flight again.</source>
        <translation>第 %2 行：缺少“%1”，或其内容与录制的飞行不符。请用文本编辑器更正，或重新保存飞行。</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is none that a recorded flight has. Take it out; if a newer version wrote it, update the program.</source>
        <translation>第 %2 行：录制的飞行没有“%1”字段。请将其删除；如果是较新版本写入的，请更新程序。</translation>
    </message>
    <message>
        <source>Line %2: the field “%1” is given a second time. Take one of the two out.</source>
        <translation>第 %2 行：字段“%1”重复出现。请删除其中一个。</translation>
    </message>
    <message>
        <source>The flight was saved by a newer version (%1; this one reads up to %2). Please update the program.</source>
        <translation>该飞行由较新版本保存（%1；当前版本最多读取到 %2）。请更新程序。</translation>
    </message>
    <message>
        <source>The flight is longer than %1 updates, so it cannot be flown again. Save a shorter one.</source>
        <translation>该飞行超过 %1 次更新，无法重放。请保存较短的飞行。</translation>
    </message>
    <message>
        <source>The bug capsule is not whole: its last line is missing. Copy it again, from its first line to its last.</source>
        <translation>错误胶囊不完整：缺少最后一行。请从第一行到最后一行重新复制。</translation>
    </message>
    <message>
        <source>The bug capsule has been changed or damaged on its way. Copy it again where it was made.</source>
        <translation>错误胶囊在传递中被更改或损坏。请在生成它的地方重新复制。</translation>
    </message>
    <message>
        <source>The bug capsule cannot be understood at “%1”. Ask for a new one.</source>
        <translation>错误胶囊在“%1”处无法理解。请索取新的胶囊。</translation>
    </message>
    <message>
        <source>The level in the bug capsule cannot be read, so ask for a new one. Line %1 of it: %2</source>
        <translation>错误胶囊中的关卡无法读取，请索取新的胶囊。其第 %1 行：%2</translation>
    </message>
    <message>
        <source>The run is larger than a bug capsule may be: %1.</source>
        <translation>运行超出错误胶囊允许的大小：%1。</translation>
    </message>
    <message>
        <source>there is no such file; it may have been moved</source>
        <translation>没有此文件；它可能已被移动</translation>
    </message>
    <message>
        <source>you do not have the permission; ask its owner for it</source>
        <translation>您没有权限；请向其所有者索取</translation>
    </message>
    <message>
        <source>the system does not permit it</source>
        <translation>系统不允许</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>它是一个文件夹</translation>
    </message>
    <message>
        <source>what should be its folder is a file</source>
        <translation>本应是其文件夹的是一个文件</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>它不是普通文件</translation>
    </message>
    <message>
        <source>its name is too long</source>
        <translation>其名称过长</translation>
    </message>
    <message>
        <source>the disk does not answer as it should; copy what it holds</source>
        <translation>磁盘响应异常；请复制其中的内容</translation>
    </message>
    <message>
        <source>no place could be made there</source>
        <translation>无法在那里创建位置</translation>
    </message>
    <message>
        <source>Change “%1” of the level</source>
        <translation>更改关卡的“%1”</translation>
    </message>
    <message>
        <source>Change “%1”</source>
        <translation>更改“%1”</translation>
    </message>
    <message numerus="yes">
        <source>Change “%1” of %n objects</source>
        <translation>
            <numerusform>更改 %n 个对象的“%1”</numerusform>
        </translation>
    </message>
    <message>
        <source>“%2” is on its way through a one-way wall of “%1”, from %3; %4 to %5; %6: it came from behind, and touches nothing until all of it is in front.</source>
        <translation>“%2”正在穿过“%1”的单向墙（从 %3; %4 到 %5; %6）：它来自背面，在完全到达正面之前不会接触任何东西。</translation>
    </message>
    <message>
        <source>“%2” is behind a one-way wall of “%1”, from %3; %4 to %5; %6, which is open from there.</source>
        <translation>“%2”位于“%1”的单向墙（从 %3; %4 到 %5; %6）背面，从那里可以通过。</translation>
    </message>
    <message>
        <source>1 node selected · drag: move · arrow keys: nudge · Delete: remove · Shift+B: break · Escape: select none</source>
        <translation>已选 1 个节点 · 拖动：移动 · 方向键：微移 · Delete：删除 · Shift+B：断开 · Esc：取消选择</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · release: done · Escape: cancel</source>
        <translation>已选节点：%1 · 松开：完成 · Esc：取消</translation>
    </message>
    <message>
        <source>Nodes selected: %1 · draw around the nodes · release: done · Escape: cancel</source>
        <translation>已选节点：%1 · 圈住节点 · 松开：完成 · Esc：取消</translation>
    </message>
    <message>
        <source>Cuts: %1 · release: cut · Shift: 15° · Ctrl: snap off/on · Escape: cancel</source>
        <translation>切口：%1 · 松开：切割 · Shift：15° · Ctrl：吸附开/关 · Esc：取消</translation>
    </message>
    <message>
        <source>Pivot at %1; %2 m · Ctrl: snap off/on · Escape: cancel</source>
        <translation>枢轴位于 %1; %2 m · Ctrl：吸附开/关 · Esc：取消</translation>
    </message>
    <message>
        <source>Locked: clicks and drags go past it</source>
        <translation>已锁定：点击和拖动会略过它</translation>
    </message>
    <message>
        <source>%1 selected · locked, so nothing changes it · Escape: select nothing</source>
        <translation>已选 %1 个 · 已锁定，不会被更改 · Esc：取消选择</translation>
    </message>
    <message>
        <source>A body without a name is not made of polygons alone. Only polygons can be united, subtracted and intersected.</source>
        <translation>一个未命名的物体并非仅由多边形组成。只有多边形才能合并、相减和求交。</translation>
    </message>
</context>
<context>
    <name>spacetow::ArrayBar</name>
    <message>
        <source>Copies</source>
        <translation>副本数</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Turn copies</source>
        <translation>旋转副本</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Make the copies (Enter)</source>
        <translation>创建副本 (Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Make no copies (Escape)</source>
        <translation>不创建副本 (Esc)</translation>
    </message>
    <message>
        <source>Radial array</source>
        <translation>环形阵列</translation>
    </message>
    <message>
        <source>Linear array</source>
        <translation>线性阵列</translation>
    </message>
    <message>
        <source>Center x</source>
        <translation>中心 x</translation>
    </message>
    <message>
        <source>Step x</source>
        <translation>步长 x</translation>
    </message>
    <message>
        <source>y</source>
        <comment>of a center or step</comment>
        <translation>y</translation>
    </message>
    <message>
        <source>Select what is to be copied.</source>
        <translation>请选择要复制的对象。</translation>
    </message>
    <message>
        <source>Of a ship, a payload and a finish a level has one: there is nothing to copy.</source>
        <translation>关卡只有一艘飞船、一个载荷和一个终点：没有可复制的内容。</translation>
    </message>
    <message>
        <source>That would be %1 objects; an array may have %2. Make fewer copies.</source>
        <translation>这将产生 %1 个对象；阵列最多可有 %2 个。请减少副本数。</translation>
    </message>
</context>
<context>
    <name>spacetow::Canvas</name>
    <message>
        <source>Drawing board</source>
        <translation>画布</translation>
    </message>
    <message>
        <source>Drawing board, running</source>
        <translation>画布，运行中</translation>
    </message>
</context>
<context>
    <name>spacetow::ColorField</name>
    <message>
        <source>mixed</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>spacetow::DifferencePanel</name>
    <message>
        <source>&amp;Compare With…</source>
        <translation>比较(&amp;C)…</translation>
    </message>
    <message>
        <source>Ta&amp;ke Over</source>
        <translation>采用(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;End</source>
        <translation>结束(&amp;E)</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>差异</translation>
    </message>
    <message>
        <source>Makes the selected objects as they are in the other level</source>
        <translation>使所选对象与另一关卡中的一致</translation>
    </message>
    <message>
        <source>Ends comparing; the level stays as it is</source>
        <translation>结束比较；关卡保持不变</translation>
    </message>
    <message>
        <source>Nothing is compared. Choose a level file to see what is different from it.</source>
        <translation>尚未比较。请选择一个关卡文件，以查看其中的差异。</translation>
    </message>
    <message>
        <source>Comparing with %1…</source>
        <translation>正在与 %1 比较…</translation>
    </message>
    <message>
        <source>Nothing is different from %1.</source>
        <translation>与 %1 没有差异。</translation>
    </message>
    <message numerus="yes">
        <source>%n differences from %1</source>
        <translation>
            <numerusform>与 %1 有 %n 处差异</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::DiskChanges</name>
    <message>
        <source>%1 is no longer there: it was deleted, moved or renamed. Your level is still here.</source>
        <translation>%1 已不在原处：已被删除、移动或重命名。您的关卡仍在这里。</translation>
    </message>
    <message>
        <source>Save Again</source>
        <translation>再次保存</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>另存为…</translation>
    </message>
    <message>
        <source>%1 was changed by another program and has been loaded anew. Undo takes that back.</source>
        <translation>%1 已被其他程序更改，并已重新加载。撤销可恢复原状。</translation>
    </message>
    <message>
        <source>%1 was changed by another program, and you have changed it here.</source>
        <translation>%1 已被其他程序更改，而您在此也有更改。</translation>
    </message>
    <message>
        <source>%1 was changed by another program and cannot be read any more. Your level is still here.</source>
        <translation>%1 已被其他程序更改，无法再读取。您的关卡仍在这里。</translation>
    </message>
    <message>
        <source>Not saved: %1 was changed by another program since you opened it, and saving would overwrite that.</source>
        <translation>未保存：%1 在您打开后已被其他程序更改，保存会将其覆盖。</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>重新加载</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>保留我的</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
</context>
<context>
    <name>spacetow::EntryBox</name>
    <message>
        <source>Speed</source>
        <translation>速率</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>宽度</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
</context>
<context>
    <name>spacetow::Exchange</name>
    <message>
        <source>There is not enough memory for a picture of this size.</source>
        <translation>内存不足，无法生成此大小的图片。</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Drawings and maps (*.svg *.tmx *.tmj *.json);;All files (*)</source>
        <translation>图形和地图 (*.svg *.tmx *.tmj *.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Export picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>PNG pictures (*.png);;SVG drawings (*.svg)</source>
        <translation>PNG 图片 (*.png);;SVG 图形 (*.svg)</translation>
    </message>
    <message>
        <source>%1 was imported as a whole.</source>
        <translation>%1 已完整导入。</translation>
    </message>
    <message>
        <source>%1 was imported, but:</source>
        <translation>%1 已导入，但是：</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… 还有 %1 项</translation>
    </message>
    <message>
        <source>The picture was written to %1.</source>
        <translation>图片已写入 %1。</translation>
    </message>
    <message>
        <source>The screenshot was written to %1.</source>
        <translation>截图已写入 %1。</translation>
    </message>
    <message>
        <source>%1 was not imported.</source>
        <translation>未导入 %1。</translation>
    </message>
</context>
<context>
    <name>spacetow::ExplainPanel</name>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>大小</translation>
    </message>
    <message>
        <source>Explanation of the selection</source>
        <translation>所选对象的说明</translation>
    </message>
    <message>
        <source>Everything. Select one object to see what moves it, or two to hear why they do not collide.</source>
        <translation>全部。选择一个对象可查看是什么在推动它，选择两个可了解它们为何不碰撞。</translation>
    </message>
    <message>
        <source>Why do these two not collide?</source>
        <translation>这两个对象为何不碰撞？</translation>
    </message>
    <message>
        <source>Select one object, or two.</source>
        <translation>请选择一个或两个对象。</translation>
    </message>
    <message>
        <source>“%1” is not part of the simulation.</source>
        <translation>“%1”不属于模拟。</translation>
    </message>
    <message>
        <source>At least one of them is no body in the simulation.</source>
        <translation>其中至少有一个不是模拟中的物体。</translation>
    </message>
</context>
<context>
    <name>spacetow::ExportBar</name>
    <message>
        <source>Export picture</source>
        <translation>导出图片</translation>
    </message>
    <message>
        <source>Whole level</source>
        <translation>整个关卡</translation>
    </message>
    <message>
        <source>What is in view</source>
        <translation>视图中的内容</translation>
    </message>
    <message>
        <source>What of the level the picture shows</source>
        <translation>图片显示关卡的哪一部分</translation>
    </message>
    <message>
        <source>Pixels of the picture for a metre of the level.</source>
        <translation>关卡中一米对应的图片像素数。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>透明</translation>
    </message>
    <message>
        <source>Leave the ground of the picture out</source>
        <translation>略去图片的背景</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Draw the grid as well</source>
        <translation>同时绘制网格</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>导出…</translation>
    </message>
    <message>
        <source>Choose a file, PNG or SVG (Enter)</source>
        <translation>选择文件，PNG 或 SVG (Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Write no picture (Escape)</source>
        <translation>不写图片 (Esc)</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 像素</translation>
    </message>
    <message>
        <source>There is nothing to be seen, or the picture would be too large: at most 16,384 pixels a side and 67 million in all. Choose another scale.</source>
        <translation>没有可见内容，或图片过大：每边最多 16,384 像素，总计最多 6700 万像素。请选择其他比例。</translation>
    </message>
</context>
<context>
    <name>spacetow::Finder</name>
    <message>
        <source>Find actions, levels, objects and problems</source>
        <translation>查找操作、关卡、对象和问题</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>查找结果</translation>
    </message>
    <message>
        <source>&gt; actions · / levels · @ objects · ! problems · Enter: take · Esc: close</source>
        <translation>&gt; 操作 · / 关卡 · @ 对象 · ! 问题 · Enter：选用 · Esc：关闭</translation>
    </message>
    <message>
        <source>Nothing is called that.</source>
        <translation>没有符合此名称的内容。</translation>
    </message>
</context>
<context>
    <name>spacetow::FlightsPanel</name>
    <message>
        <source>No flight is stored beside this level. A flight of cave.json is a file cave.replay.json or cave.NAME.replay.json in the same folder.</source>
        <translation>此关卡旁没有保存飞行记录。cave.json 的飞行记录是同一文件夹中的 cave.replay.json 或 cave.NAME.replay.json 文件。</translation>
    </message>
    <message>
        <source>Flights</source>
        <translation>飞行记录</translation>
    </message>
</context>
<context>
    <name>spacetow::Form</name>
    <message>
        <source>Fold or unfold this section</source>
        <translation>折叠或展开此部分</translation>
    </message>
    <message>
        <source>Back to the default</source>
        <translation>恢复默认值</translation>
    </message>
    <message>
        <source>Back to the default: %1</source>
        <translation>恢复默认值：%1</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>Stars</source>
        <translation>星空</translation>
    </message>
    <message>
        <source>Plain</source>
        <translation>纯色</translation>
    </message>
    <message>
        <source>%1 of the %2 selected objects have this.</source>
        <translation>所选 %2 个对象中有 %1 个具有此项。</translation>
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
        <translation>名称</translation>
    </message>
    <message>
        <source>X of the guide</source>
        <translation>参考线的 X</translation>
    </message>
    <message>
        <source>Y of the guide</source>
        <translation>参考线的 Y</translation>
    </message>
    <message>
        <source>Angle of the guide</source>
        <translation>参考线的角度</translation>
    </message>
    <message>
        <source>Name of the guide</source>
        <translation>参考线的名称</translation>
    </message>
    <message>
        <source>Delete this guide</source>
        <translation>删除此参考线</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryModel</name>
    <message numerus="yes">
        <source>%n older changes that can no longer be undone</source>
        <translation>
            <numerusform>%n 项较早的更改已无法撤销</numerusform>
        </translation>
    </message>
    <message>
        <source>present state</source>
        <translation>当前状态</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>saved</source>
        <translation>已保存</translation>
    </message>
    <message>
        <source>Saved: the file holds this state</source>
        <translation>已保存：文件为此状态</translation>
    </message>
</context>
<context>
    <name>spacetow::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Click to go back, or forward again, to the state after an edit</source>
        <translation>单击可后退或前进到某次编辑之后的状态</translation>
    </message>
</context>
<context>
    <name>spacetow::ImportBar</name>
    <message>
        <source>Progress of the import</source>
        <translation>导入进度</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>导入</translation>
    </message>
    <message>
        <source>Add what is shown to the level (Enter)</source>
        <translation>把显示的内容加入关卡 (Enter)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Leave the level as it was (Escape)</source>
        <translation>关卡保持不变 (Esc)</translation>
    </message>
    <message>
        <source>What a unit of the file is: a pixel of a drawing, a pixel of a map.</source>
        <translation>文件中一个单位的大小：图形的像素或地图的像素。</translation>
    </message>
    <message>
        <source>How far straight segments may stray from a curve.</source>
        <translation>直线段与曲线之间允许的偏差。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>比例</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>容差</translation>
    </message>
    <message>
        <source>Two-way walls</source>
        <translation>双向线</translation>
    </message>
    <message>
        <source>One-way walls</source>
        <translation>单向墙</translation>
    </message>
    <message>
        <source>What lines without a fill become</source>
        <translation>无填充的线变成什么</translation>
    </message>
    <message>
        <source>Fills as polygons</source>
        <translation>填充作为多边形</translation>
    </message>
    <message>
        <source>Fills as walls</source>
        <translation>填充作为墙</translation>
    </message>
    <message>
        <source>What filled shapes become</source>
        <translation>有填充的形状变成什么</translation>
    </message>
    <message>
        <source>New layer</source>
        <translation>新建图层</translation>
    </message>
    <message>
        <source>Put all of it into a new layer, named like the file</source>
        <translation>把全部内容放入新图层，以文件命名</translation>
    </message>
    <message>
        <source>Center in view</source>
        <translation>在视图中居中</translation>
    </message>
    <message>
        <source>Put it into the middle of the view, else where the file has it</source>
        <translation>放到视图中央；否则按文件中的位置</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>导入 %1</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>%1 objects, %2 vertices, %3 × %4 m</source>
        <translation>%1 个对象，%2 个顶点，%3 × %4 m</translation>
    </message>
    <message>
        <source>… and %1 more</source>
        <translation>… 还有 %1 项</translation>
    </message>
</context>
<context>
    <name>spacetow::Inspector</name>
    <message>
        <source>A group cannot be put into itself.</source>
        <translation>组不能放入自身。</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形状</translation>
    </message>
    <message>
        <source>Which shape the fields of shapes speak of</source>
        <translation>形状字段针对哪个形状</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>关卡</translation>
    </message>
    <message>
        <source>Nothing is selected.</source>
        <translation>未选择任何对象。</translation>
    </message>
    <message numerus="yes">
        <source>All %n shapes</source>
        <translation>
            <numerusform>全部 %n 个形状</numerusform>
        </translation>
    </message>
    <message>
        <source>Shape %1: %2</source>
        <translation>形状 %1：%2</translation>
    </message>
    <message numerus="yes">
        <source>%1, %n nodes selected</source>
        <translation>
            <numerusform>%1，已选 %n 个节点</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>这会超出字段的范围，因此未做更改。</translation>
    </message>
    <message numerus="yes">
        <source>%n of the values would leave the range of the field, so nothing has changed.</source>
        <translation>
            <numerusform>有 %n 个值会超出字段的范围，因此未做更改。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>spacetow::KeyEditor</name>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Find an action or a key</source>
        <translation>查找操作或按键</translation>
    </message>
    <message>
        <source>My own</source>
        <translation>自定义</translation>
    </message>
    <message>
        <source>Keys as in</source>
        <translation>按键方案</translation>
    </message>
    <message>
        <source>Take all keys from a program that you know</source>
        <translation>采用您熟悉的程序的全部按键</translation>
    </message>
    <message>
        <source>Keys as &amp;in</source>
        <translation>按键方案(&amp;I)</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>导入(&amp;I)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>Reset &amp;All</source>
        <translation>全部重置(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last change of keys</source>
        <translation>撤销上一次按键更改</translation>
    </message>
    <message>
        <source>&amp;Take It Over</source>
        <translation>改用于此(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>重置(&amp;R)</translation>
    </message>
    <message>
        <source>Give this action the keys that it came with</source>
        <translation>恢复此操作的默认按键</translation>
    </message>
    <message>
        <source>Take %1 away</source>
        <translation>移除 %1</translation>
    </message>
    <message>
        <source>%1 leads to “%2” (%3).</source>
        <translation>%1 已用于“%2”（%3）。</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now, and no longer to “%3”.</source>
        <translation>%1 现用于“%2”，不再用于“%3”。</translation>
    </message>
    <message>
        <source>%1 leads to “%2” now.</source>
        <translation>%1 现用于“%2”。</translation>
    </message>
    <message>
        <source>Keys (*.json);;All files (*)</source>
        <translation>按键 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Import Keys</source>
        <translation>导入按键</translation>
    </message>
    <message>
        <source>Export Keys</source>
        <translation>导出按键</translation>
    </message>
    <message>
        <source>“%1” cannot be read: %2.</source>
        <translation>无法读取“%1”：%2。</translation>
    </message>
    <message>
        <source>“%1” is too large to be a file of keys.</source>
        <translation>“%1”过大，不会是按键文件。</translation>
    </message>
    <message>
        <source>Nothing was taken from “%1”.</source>
        <translation>未从“%1”采用任何内容。</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now.</source>
        <translation>现在采用“%1”的按键。</translation>
    </message>
    <message>
        <source>These are the keys of “%1” now. Nothing is called %2 here.</source>
        <translation>现在采用“%1”的按键。此处没有名为 %2 的操作。</translation>
    </message>
    <message>
        <source>Wrote all keys to “%1”.</source>
        <translation>已把所有按键写入“%1”。</translation>
    </message>
    <message>
        <source>“%1” cannot be written: %2.</source>
        <translation>无法写入“%1”：%2。</translation>
    </message>
    <message>
        <source>This key cannot be changed, so that there is always a way out of the game.</source>
        <translation>此按键不能更改，以便始终可以退出游戏。</translation>
    </message>
</context>
<context>
    <name>spacetow::KeyRecorder</name>
    <message>
        <source>Press a key</source>
        <translation>请按一个键</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新按键</translation>
    </message>
</context>
<context>
    <name>spacetow::KeysDialog</name>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Search: a word, or a key as it is written</source>
        <translation>搜索：一个词，或按键的写法</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>No key does anything of that name.</source>
        <translation>没有按键对应此名称。</translation>
    </message>
</context>
<context>
    <name>spacetow::Legend</name>
    <message>
        <source>Legend of the overlays</source>
        <translation>叠加显示的图例</translation>
    </message>
    <message>
        <source>Hide the legend</source>
        <translation>隐藏图例</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>图例</translation>
    </message>
    <message>
        <source>Switch off</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>选择其他颜色</translation>
    </message>
    <message>
        <source>What is too small at this zoom is not drawn</source>
        <translation>在此缩放比例下过小的内容不绘制</translation>
    </message>
    <message>
        <source>Names that would lie on others are left out</source>
        <translation>会与其他名称重叠的名称已省略</translation>
    </message>
</context>
<context>
    <name>spacetow::LevelPanel</name>
    <message>
        <source>That would leave the range of the field, so nothing has changed.</source>
        <translation>这会超出字段的范围，因此未做更改。</translation>
    </message>
</context>
<context>
    <name>spacetow::MainWindow</name>
    <message>
        <source>&amp;Undo</source>
        <translation>撤销(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>重做(&amp;R)</translation>
    </message>
    <message>
        <source>There is nothing on the clipboard that can be pasted here.</source>
        <translation>剪贴板上没有可在此粘贴的内容。</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>已保存 %1</translation>
    </message>
    <message>
        <source>Read %1 again</source>
        <translation>已重新读取 %1</translation>
    </message>
    <message>
        <source>About SpaceTow Studio</source>
        <translation>关于 SpaceTow Studio</translation>
    </message>
    <message>
        <source>SpaceTow Studio %1</source>
        <translation>SpaceTow Studio %1</translation>
    </message>
    <message>
        <source>Draw levels and fly them: a level editor and physics sandbox.

Free software under the MIT license. Made with Qt %1 and Eigen.</source>
        <translation>绘制关卡并驾船飞行：关卡编辑器和物理沙盒。

采用 MIT 许可证的自由软件。使用 Qt %1 和 Eigen 制作。</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
    <message>
        <source>Was open at the end of the last run, but is gone: %1</source>
        <translation>上次退出时处于打开状态，但现已不存在：%1</translation>
    </message>
    <message>
        <source>comes with the program</source>
        <translation>程序自带</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>关卡</translation>
    </message>
    <message numerus="yes">
        <source>The level has %n errors and may not play as it should; see Problems.</source>
        <translation>
            <numerusform>关卡有 %n 个错误，可能无法正常游玩；请查看“问题”。</numerusform>
        </translation>
    </message>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>won</source>
        <translation>获胜</translation>
    </message>
    <message>
        <source>crashed</source>
        <translation>已坠毁</translation>
    </message>
    <message>
        <source>game over</source>
        <translation>游戏结束</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>就绪</translation>
    </message>
    <message>
        <source>playing</source>
        <translation>游戏中</translation>
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
        <translation>新关卡</translation>
    </message>
    <message>
        <source>Opened %1</source>
        <translation>已打开 %1</translation>
    </message>
    <message>
        <source>No level is open · arrows, Tab and Enter choose one</source>
        <translation>没有打开的关卡 · 用方向键、Tab 和 Enter 选择</translation>
    </message>
    <message>
        <source>snaps to: %1</source>
        <translation>吸附到：%1</translation>
    </message>
    <message>
        <source>Nothing was left unsaved.</source>
        <translation>没有未保存的内容。</translation>
    </message>
    <message>
        <source>Main</source>
        <translation>主工具栏</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation>尚无文件</translation>
    </message>
    <message>
        <source>&amp;Clear List</source>
        <translation>清空列表(&amp;C)</translation>
    </message>
    <message>
        <source>Take back the level as it was saved then, as one edit; its file stays as it is</source>
        <translation>把关卡恢复为当时保存的状态，计为一次编辑；文件保持不变</translation>
    </message>
    <message>
        <source>No former versions yet</source>
        <translation>尚无以前的版本</translation>
    </message>
    <message>
        <source>Select &amp;Under Pointer</source>
        <translation>选择指针下的对象(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>打开最近文件(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Backups</source>
        <translation>备份(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>O&amp;verlays</source>
        <translation>叠加显示(&amp;V)</translation>
    </message>
    <message>
        <source>S&amp;napping</source>
        <translation>吸附(&amp;N)</translation>
    </message>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>网格步长(&amp;T)</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>子网格(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>面板(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外观(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>插入(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>对象(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Order</source>
        <translation>次序(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>对齐(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Transform</source>
        <translation>变换(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Path</source>
        <translation>路径(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation>关卡(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>试玩(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation>窗口(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>Should the program end all of a sudden, what is not saved will be lost:</source>
        <translation>如果程序意外结束，未保存的内容将丢失：</translation>
    </message>
    <message>
        <source>%1 is open in another window too. What is saved there will arrive here.</source>
        <translation>%1 也在另一个窗口中打开。在那里保存的内容会同步到这里。</translation>
    </message>
    <message>
        <source>Texts in this language from now on, in all windows</source>
        <translation>从现在起所有窗口都使用此语言</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>跟随桌面(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>语言(&amp;G)</translation>
    </message>
    <message>
        <source>The game was ended: so many bodies lie in the same place that the computer&apos;s memory would not hold what happens between them. Move them apart, and play again.</source>
        <translation>游戏已结束：同一位置的物体过多，计算机内存无法容纳它们之间的相互作用。请将它们分开后再玩。</translation>
    </message>
    <message>
        <source>The game was ended: there is not enough memory for this level. Nothing of the level is lost.</source>
        <translation>游戏已结束：内存不足以运行此关卡。关卡内容没有丢失。</translation>
    </message>
    <message>
        <source>what was not saved of %1</source>
        <translation>%1 中未保存的内容</translation>
    </message>
    <message>
        <source>Write plots</source>
        <translation>输出曲线</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表格 (*.csv)</translation>
    </message>
    <message>
        <source>Save flight</source>
        <translation>保存飞行记录</translation>
    </message>
    <message>
        <source>Flights (*.replay.json)</source>
        <translation>飞行记录 (*.replay.json)</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 fps</translation>
    </message>
    <message>
        <source>The plots are in “%1”.</source>
        <translation>曲线数据已写入“%1”。</translation>
    </message>
    <message>
        <source>Pulling · move: pull further · let the button go: throw</source>
        <translation>正在拉动 · 移动：继续拉 · 松开按键：抛出</translation>
    </message>
    <message>
        <source>Playing a recorded flight · who steers takes over · %1: back to the editor</source>
        <translation>正在播放飞行记录 · 操控即可接管 · %1：返回编辑器</translation>
    </message>
    <message>
        <source>%1: follow the ship again</source>
        <translation>%1：重新跟随飞船</translation>
    </message>
    <message>
        <source>Playing · drag a body: pull it · wheel, right drag: move the view · %1 held: back in time · %2: back to the editor · Esc: menu</source>
        <translation>试玩中 · 拖动物体：拉动它 · 滚轮、右键拖动：移动视图 · 按住 %1：时间倒退 · %2：返回编辑器 · Esc：菜单</translation>
    </message>
    <message>
        <source>Simulation held · click: select · drag: move · %1: go on from here · %2: next frame · %3: back to the editor</source>
        <translation>模拟已暂停 · 单击：选择 · 拖动：移动 · %1：从此处继续 · %2：下一帧 · %3：返回编辑器</translation>
    </message>
    <message>
        <source>Simulation running · click: select · drag: pull a body, move what stands still · %1: hold · %2: back to the editor</source>
        <translation>模拟运行中 · 单击：选择 · 拖动：拉动物体，移动静止的对象 · %1：暂停 · %2：返回编辑器</translation>
    </message>
    <message>
        <source>Here begins a new level.
%1: draw the walls of a cave, anticlockwise
%2: place ship, payload and finish
%3: play
%4, %5: draw boxes and balls
%6: simulate
%7: find everything else</source>
        <translation>新关卡从这里开始。
%1：逆时针绘制洞穴的墙
%2：放置飞船、货物和终点
%3：游玩
%4、%5：绘制箱子和球
%6：模拟
%7：查找其他一切</translation>
    </message>
    <message>
        <source>simulating</source>
        <translation>模拟中</translation>
    </message>
    <message>
        <source>Simulate</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>Held within an update, after iteration %1 of %2 · %3: next iteration · %4: go on from here</source>
        <translation>在一次更新内暂停，第 %1/%2 次迭代之后 · %3：下一次迭代 · %4：从此处继续</translation>
    </message>
    <message>
        <source>Held · %1: go on from here · %2: next frame · %3: previous frame · %4: back to the editor</source>
        <translation>已暂停 · %1：从此处继续 · %2：下一帧 · %3：上一帧 · %4：返回编辑器</translation>
    </message>
    <message>
        <source> · it will move; walls and lines stand still</source>
        <translation> · 它会移动；墙和线静止不动</translation>
    </message>
    <message>
        <source>Getting ready to run: %1 s so far · %2: leave it</source>
        <translation>正在准备运行：已 %1 秒 · %2：放弃</translation>
    </message>
    <message>
        <source>Too much for this computer: %1 s behind real time · %2: back to the editor</source>
        <translation>对本机来说负担过重：落后实时 %1 秒 · %2：返回编辑器</translation>
    </message>
    <message>
        <source>Simulating the run: %1 of %2 s so far · %3: leave it</source>
        <translation>正在模拟运行：已完成 %1 / %2 秒 · %3：放弃</translation>
    </message>
    <message>
        <source>Playing a recorded simulation · %1: back to the editor</source>
        <translation>正在播放录制的模拟 · %1：返回编辑器</translation>
    </message>
    <message>
        <source>A connector is pasted together with the two bodies that it joins.</source>
        <translation>连接件须与其连接的两个物体一起粘贴。</translation>
    </message>
    <message>
        <source>A level has one ship, one payload and one finish, and this one has them already.</source>
        <translation>一个关卡只有一艘飞船、一个载荷和一个终点，本关卡已具备。</translation>
    </message>
    <message>
        <source>Nothing that is selected has an edge at the pointer.</source>
        <translation>所选对象在指针处没有边。</translation>
    </message>
    <message>
        <source>Edit N&amp;odes</source>
        <translation>编辑节点(&amp;O)</translation>
    </message>
    <message>
        <source>%1: unlock all</source>
        <translation>%1：全部解锁</translation>
    </message>
    <message>
        <source>Reading %1: %2 s so far · %3: leave it</source>
        <translation>正在读取 %1：已 %2 秒 · %3：放弃</translation>
    </message>
</context>
<context>
    <name>spacetow::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
</context>
<context>
    <name>spacetow::Minimap</name>
    <message>
        <source>Minimap</source>
        <translation>小地图</translation>
    </message>
    <message>
        <source>Click or drag: go there · wheel: zoom · arrows: move the view</source>
        <translation>单击或拖动：转到该处 · 滚轮：缩放 · 方向键：移动视图</translation>
    </message>
</context>
<context>
    <name>spacetow::MotionLine</name>
    <message>
        <source>Now, while it runs</source>
        <translation>运行中的当前状态</translation>
    </message>
    <message>
        <source>How the body moves now, while it runs; the fields say where it starts</source>
        <translation>物体在运行中当前的运动状态；各字段表示其起始状态</translation>
    </message>
    <message>
        <source>Now: x %1 · y %2 m · %3°</source>
        <translation>当前：x %1 · y %2 m · %3°</translation>
    </message>
    <message>
        <source>%1 m/s (x %2 · y %3) · %4°/s</source>
        <translation>%1 m/s (x %2 · y %3) · %4°/s</translation>
    </message>
    <message>
        <source>Now: %1 m long, %2 m at rest</source>
        <translation>当前：长 %1 m，自然长度 %2 m</translation>
    </message>
    <message>
        <source>pushes with %1 N</source>
        <translation>推力 %1 N</translation>
    </message>
    <message>
        <source>pulls with %1 N</source>
        <translation>拉力 %1 N</translation>
    </message>
    <message>
        <source>Now: not there any more</source>
        <translation>当前：已不存在</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesDelegate</name>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>这会超出地图，地图边界距原点 %1 m。</translation>
    </message>
</context>
<context>
    <name>spacetow::NodesModel</name>
    <message>
        <source>shape %1: %2</source>
        <translation>形状 %1：%2</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>节点</translation>
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
        <translation>正在编辑的对象的节点</translation>
    </message>
    <message>
        <source>Double click or type to change a coordinate; with several rows selected, in all of them</source>
        <translation>双击或直接输入以更改坐标；选中多行时全部更改</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>插入</translation>
    </message>
    <message>
        <source>Insert a node halfway to the next one</source>
        <translation>在到下一节点的中点处插入节点</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the selected nodes</source>
        <translation>删除所选节点</translation>
    </message>
</context>
<context>
    <name>spacetow::NumberField</name>
    <message>
        <source>Type a number or an expression such as 2*pi/3, 20 cm, +=0.5 or *=2 · Up, Down, wheel: step · Shift: finer · Ctrl: coarser</source>
        <translation>输入数字或表达式，如 2*pi/3、20 cm、+=0.5 或 *=2 · 上下键、滚轮：步进 · Shift：更细 · Ctrl：更粗</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>Exactly %1 %2</source>
        <translation>精确值 %1 %2</translation>
    </message>
    <message>
        <source>A whole number</source>
        <translation>整数</translation>
    </message>
    <message>
        <source>A number</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>%1 above %2 and up to %3</source>
        <translation>%1，大于 %2 且不超过 %3</translation>
    </message>
    <message>
        <source>%1 from %2 to %3</source>
        <translation>%1，从 %2 到 %3</translation>
    </message>
    <message>
        <source>%1 above %2</source>
        <translation>%1，大于 %2</translation>
    </message>
    <message>
        <source>%1 of %2 or more</source>
        <translation>%1，不小于 %2</translation>
    </message>
    <message>
        <source>%1, or nothing</source>
        <translation>%1，或留空</translation>
    </message>
    <message>
        <source>The result is too large.</source>
        <translation>结果过大。</translation>
    </message>
    <message>
        <source>%1 is not possible: %2.</source>
        <translation>%1 无效：%2。</translation>
    </message>
    <message>
        <source>“%1” is no number.</source>
        <translation>“%1”不是数字。</translation>
    </message>
</context>
<context>
    <name>spacetow::ObjectField</name>
    <message>
        <source>There is no object with this key.</source>
        <translation>没有具有此标识的对象。</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>不一致</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Nothing here is called “%1”; write the name or the key of another object.</source>
        <translation>此处没有名为“%1”的对象；请填写另一个对象的名称或标识。</translation>
    </message>
    <message>
        <source>Several objects are called “%1”; write the key of the one you mean.</source>
        <translation>有多个对象名为“%1”；请填写所指对象的标识。</translation>
    </message>
    <message>
        <source>Choose from a list (Down)</source>
        <translation>从列表中选择（下键）</translation>
    </message>
    <message>
        <source>%1, key %2</source>
        <translation>%1，键 %2</translation>
    </message>
    <message>
        <source>Select it and bring it into the middle of the view</source>
        <translation>选中并移到视图中央</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerModel</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Color of the group. Click to choose another one</source>
        <translation>组的颜色。单击可另选</translation>
    </message>
    <message>
        <source>Hidden in the editor; played all the same. Click to show it</source>
        <translation>在编辑器中隐藏；游戏中仍然有效。单击可显示</translation>
    </message>
    <message>
        <source>Visible. Click to hide it in the editor</source>
        <translation>可见。单击可在编辑器中隐藏</translation>
    </message>
    <message>
        <source>Locked: not picked on the canvas, moved or deleted. Click to unlock it</source>
        <translation>已锁定：不能在画布上拾取、移动或删除。单击可解锁</translation>
    </message>
    <message>
        <source>Not locked. Click to lock it against changes</source>
        <translation>未锁定。单击可锁定以防更改</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>已隐藏</translation>
    </message>
    <message>
        <source>visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>已锁定</translation>
    </message>
    <message>
        <source>not locked</source>
        <translation>未锁定</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>Color</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>可见</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>已锁定</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerPanel</name>
    <message>
        <source>What is locked stays where it is; unlock it to move it.</source>
        <translation>已锁定的对象不会移动；请先解锁再移动。</translation>
    </message>
    <message>
        <source>Find: name, kind:wall, tag:ice</source>
        <translation>查找：名称、kind:wall、tag:ice</translation>
    </message>
    <message>
        <source>Filter of the objects</source>
        <translation>对象过滤器</translation>
    </message>
    <message>
        <source>Choose what to find</source>
        <translation>选择查找条件</translation>
    </message>
    <message>
        <source>Color of the Group</source>
        <translation>组的颜色</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Shows the objects whose name holds these words, with their groups.
kind:wall, tag:ice, is:hidden and is:locked ask for other things; a minus before a word turns it round. Enter selects all that is found.
The list shows what is drawn on top first.</source>
        <translation>显示名称包含这些词的对象及其所在的组。
kind:wall、tag:ice、is:hidden 和 is:locked 用于查询其他内容；词前的减号表示取反。回车选择所有找到的对象。
列表先显示绘制在最上层的对象。</translation>
    </message>
</context>
<context>
    <name>spacetow::OutlinerView</name>
    <message>
        <source>Objects of the level</source>
        <translation>关卡的对象</translation>
    </message>
    <message>
        <source>No object matches the filter.</source>
        <translation>没有符合过滤器的对象。</translation>
    </message>
    <message>
        <source>The level has no objects.</source>
        <translation>关卡没有对象。</translation>
    </message>
</context>
<context>
    <name>spacetow::OverlayColorsDialog</name>
    <message>
        <source>&amp;Set of colors:</source>
        <translation>配色方案(&amp;S)：</translation>
    </message>
    <message>
        <source>&amp;Forget Own Colors</source>
        <translation>清除自定颜色(&amp;F)</translation>
    </message>
    <message>
        <source>Colors of the overlays</source>
        <translation>叠加层的颜色</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Okabe and Ito, safe with any color vision</source>
        <translation>Okabe 与 Ito，适合任何色觉</translation>
    </message>
    <message>
        <source>Choose another color</source>
        <translation>选择其他颜色</translation>
    </message>
    <message>
        <source>The color of the set again</source>
        <translation>恢复方案的颜色</translation>
    </message>
    <message>
        <source>%1: the color of the set again</source>
        <translation>%1：恢复方案的颜色</translation>
    </message>
</context>
<context>
    <name>spacetow::PauseMenu</name>
    <message>
        <source>You made it!</source>
        <translation>成功了！</translation>
    </message>
    <message>
        <source>Crashed</source>
        <translation>已坠毁</translation>
    </message>
    <message>
        <source>Game over</source>
        <translation>游戏结束</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>已暂停</translation>
    </message>
    <message>
        <source>Resume</source>
        <translation>继续</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>Back to the editor</source>
        <translation>返回编辑器</translation>
    </message>
    <message>
        <source>Stop playing</source>
        <translation>停止游戏</translation>
    </message>
    <message>
        <source>Go on playing</source>
        <translation>继续游戏</translation>
    </message>
    <message>
        <source>Start the level over</source>
        <translation>重新开始关卡</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotPanel</name>
    <message>
        <source>Quantity of the selection</source>
        <translation>所选对象的物理量</translation>
    </message>
    <message>
        <source>What of the selected body or connector, or of everything, is to be plotted</source>
        <translation>要绘制所选物体、连接件或整个系统的哪个物理量</translation>
    </message>
    <message>
        <source>Add curve</source>
        <translation>添加曲线</translation>
    </message>
    <message>
        <source>x against y</source>
        <translation>x 对 y</translation>
    </message>
    <message>
        <source>The second curve against the first, in place of all over time</source>
        <translation>以第一条曲线为横轴绘制第二条曲线，而不是全部随时间绘制</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Write what is plotted into a file that spreadsheets read</source>
        <translation>把绘制的数据写入电子表格可读取的文件</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>清除</translation>
    </message>
    <message>
        <source>Remove all curves</source>
        <translation>移除所有曲线</translation>
    </message>
    <message>
        <source>Drift: how far energy has come from its first value, as a share of the most that was ever in motion or in springs; and momentum, as a share of the most that all bodies had</source>
        <translation>漂移：能量偏离初始值的程度，以运动或弹簧中曾有的最大能量为基准的比例；动量则以所有物体曾有的最大动量为基准</translation>
    </message>
    <message>
        <source>Select a body or a connector, choose a quantity and add its curve. It grows while the level is played or simulated.</source>
        <translation>选择一个物体或连接件，选定物理量并添加其曲线。试玩或模拟关卡时曲线会不断延伸。</translation>
    </message>
    <message>
        <source>Remove the curve “%1”</source>
        <translation>移除曲线“%1”</translation>
    </message>
    <message>
        <source>Nothing runs.</source>
        <translation>没有正在运行的内容。</translation>
    </message>
    <message>
        <source>Energy %1 J, %2 J since the start (drift %3) · momentum %4 kg m/s (drift %5)</source>
        <translation>能量 %1 J，自开始以来 %2 J（漂移 %3）· 动量 %4 kg m/s（漂移 %5）</translation>
    </message>
</context>
<context>
    <name>spacetow::PlotView</name>
    <message>
        <source>Plot</source>
        <translation>曲线图</translation>
    </message>
    <message>
        <source>Wheel: zoom · drag: move · double-click: show everything</source>
        <translation>滚轮：缩放 · 拖动：移动 · 双击：全部显示</translation>
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
        <translation>修复</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemList</name>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>spacetow::ProblemsPanel</name>
    <message>
        <source>Show notes: what could be tidied</source>
        <translation>显示提示：可以整理之处</translation>
    </message>
    <message>
        <source>Show warnings</source>
        <translation>显示警告</translation>
    </message>
    <message>
        <source>Show errors</source>
        <translation>显示错误</translation>
    </message>
    <message>
        <source>Show the problems that are hidden in this level, too</source>
        <translation>同时显示在此关卡中隐藏的问题</translation>
    </message>
    <message>
        <source>Cure all problems whose fix changes nothing that was meant</source>
        <translation>修复所有不会改变设计意图的问题</translation>
    </message>
    <message>
        <source>Problems of the level</source>
        <translation>关卡的问题</translation>
    </message>
    <message>
        <source>Hidden: %1</source>
        <translation>已隐藏：%1</translation>
    </message>
    <message>
        <source>Fix all that is safe: %1</source>
        <translation>修复所有安全的问题：%1</translation>
    </message>
    <message>
        <source>Checking…</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>Nothing to complain about.</source>
        <translation>没有发现问题。</translation>
    </message>
    <message>
        <source>Nothing else: the rest is filtered out or hidden.</source>
        <translation>没有其他问题：其余的已被过滤或隐藏。</translation>
    </message>
    <message>
        <source>Fix: %1</source>
        <translation>修复：%1</translation>
    </message>
    <message>
        <source>Show it again</source>
        <translation>重新显示</translation>
    </message>
    <message>
        <source>Hide it in this level</source>
        <translation>在此关卡中隐藏</translation>
    </message>
    <message>
        <source>Copy text</source>
        <translation>复制文本</translation>
    </message>
    <message>
        <source>Nothing was found that would cure this by itself.</source>
        <translation>没有找到可以自动修复此问题的方法。</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfileChart</name>
    <message>
        <source>Times of the last updates</source>
        <translation>最近时间步的耗时</translation>
    </message>
    <message>
        <source>The last updates, newest at the right; the colors are those of the stages below</source>
        <translation>最近的时间步，最新的在右侧；颜色与下方各阶段对应</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Times are taken while the level is played or simulated.</source>
        <translation>试玩或模拟关卡时会测量耗时。</translation>
    </message>
</context>
<context>
    <name>spacetow::ProfilePanel</name>
    <message>
        <source>Stage, ms</source>
        <translation>阶段，ms</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Times and counters</source>
        <translation>耗时和计数</translation>
    </message>
    <message>
        <source>Total</source>
        <translation>合计</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryBar</name>
    <message>
        <source>The program ended with work that was not saved:</source>
        <translation>程序结束时有未保存的工作：</translation>
    </message>
    <message>
        <source>Not now: it is kept, and offered again</source>
        <translation>暂不处理：内容会保留并再次提示</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Beside the file as it is now:</source>
        <translation>与现有文件的对照：</translation>
    </message>
    <message>
        <source>There is no file to compare it with:</source>
        <translation>没有可供比较的文件：</translation>
    </message>
    <message>
        <source>It is the same as the file.</source>
        <translation>与文件相同。</translation>
    </message>
</context>
<context>
    <name>spacetow::RecoveryRow</name>
    <message numerus="yes">
        <source>%n objects</source>
        <translation>
            <numerusform>%n 个对象</numerusform>
        </translation>
    </message>
    <message>
        <source>never saved</source>
        <translation>从未保存</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>放弃</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Go on with this level; its file stays as it is until you save</source>
        <translation>继续编辑此关卡；在您保存之前，文件保持不变</translation>
    </message>
    <message>
        <source>Do not offer this any more</source>
        <translation>不再提示此项</translation>
    </message>
    <message>
        <source>Discarded.</source>
        <translation>已放弃。</translation>
    </message>
    <message>
        <source>Say and show what differs from the file</source>
        <translation>说明并显示与文件的不同之处</translation>
    </message>
</context>
<context>
    <name>spacetow::Ruler</name>
    <message>
        <source>Ruler above the drawing board</source>
        <translation>画布上方的标尺</translation>
    </message>
    <message>
        <source>Ruler beside the drawing board</source>
        <translation>画布旁边的标尺</translation>
    </message>
    <message>
        <source>Metres; drag a horizontal guide out of the ruler</source>
        <translation>米；可从标尺拖出水平参考线</translation>
    </message>
    <message>
        <source>Metres; drag a vertical guide out of the ruler</source>
        <translation>米；可从标尺拖出垂直参考线</translation>
    </message>
</context>
<context>
    <name>spacetow::RulerCorner</name>
    <message>
        <source>Corner of the rulers</source>
        <translation>标尺的角</translation>
    </message>
    <message>
        <source>Metres; drag a slanting guide out of the corner</source>
        <translation>米；可从角上拖出倾斜参考线</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesList</name>
    <message>
        <source>Is kept only together with:
%1</source>
        <translation>只能与以下更改一起保留：
%1</translation>
    </message>
</context>
<context>
    <name>spacetow::RunChangesPanel</name>
    <message>
        <source>Keep &amp;All</source>
        <translation>全部保留(&amp;A)</translation>
    </message>
    <message>
        <source>Keep &amp;Ticked</source>
        <translation>保留勾选项(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Discard All</source>
        <translation>全部放弃(&amp;D)</translation>
    </message>
    <message>
        <source>Changes made in this run</source>
        <translation>此次运行中的更改</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, each as one step that can be undone</source>
        <translation>在关卡中执行所有这些更改，每项更改为一个可撤销的步骤</translation>
    </message>
    <message>
        <source>Makes those that are ticked in the level, and forgets the others</source>
        <translation>在关卡中执行勾选的更改，舍弃其余更改</translation>
    </message>
    <message>
        <source>Leaves the level as it was before the run; Undo brings the changes back</source>
        <translation>使关卡保持运行之前的样子；“撤销”可恢复这些更改</translation>
    </message>
    <message numerus="yes">
        <source>%n changes were made in this run. The level is as before; keep what you like.</source>
        <translation>
            <numerusform>此次运行中进行了 %n 项更改。关卡与之前相同；请保留您想要的更改。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing waits to be kept. What is changed in a level while it runs is listed here when the run ends.</source>
        <translation>没有等待保留的更改。关卡运行时所做的更改会在运行结束后列在这里。</translation>
    </message>
    <message>
        <source>Makes all of these changes in the level, as one step that can be undone</source>
        <translation>在关卡中进行所有这些更改，作为可撤销的一步</translation>
    </message>
    <message>
        <source>The end of the run is undone: what was changed in it is in the level again. Redo takes it out, and lists it to be kept.</source>
        <translation>已撤销运行的结束：其中的更改重新回到关卡中。重做会将其移出并列出以供保留。</translation>
    </message>
</context>
<context>
    <name>spacetow::ScrubLabel</name>
    <message>
        <source>Drag: change the number · Shift: a tenth as fast · Ctrl: in whole steps · Escape: take it back</source>
        <translation>拖动：更改数字 · Shift：十分之一速度 · Ctrl：按整步 · Esc：还原</translation>
    </message>
</context>
<context>
    <name>spacetow::StatusLine</name>
    <message>
        <source>Grid S&amp;tep</source>
        <translation>网格步长(&amp;T)</translation>
    </message>
    <message>
        <source>Su&amp;b-Grid</source>
        <translation>子网格(&amp;B)</translation>
    </message>
    <message>
        <source>How points snap; Shift+G switches the grid, Shift+S the rest, Ctrl suspends both</source>
        <translation>点的吸附方式；Shift+G 切换网格，Shift+S 切换其余，Ctrl 暂停两者</translation>
    </message>
    <message>
        <source>Next problem (F4)</source>
        <translation>下一个问题 (F4)</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 份</translation>
    </message>
    <message>
        <source>x %1  y %2 m</source>
        <translation>x %1  y %2 m</translation>
    </message>
    <message numerus="yes">
        <source>%n selected</source>
        <translation>
            <numerusform>已选 %n 项</numerusform>
        </translation>
    </message>
    <message>
        <source>, %1 × %2 m</source>
        <translation>，%1 × %2 m</translation>
    </message>
    <message>
        <source>Snap %1 m</source>
        <translation>吸附 %1 m</translation>
    </message>
    <message>
        <source>Snap to objects</source>
        <translation>吸附到对象</translation>
    </message>
    <message>
        <source>Snap off</source>
        <translation>吸附关闭</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1，%2</translation>
    </message>
    <message numerus="yes">
        <source>%n errors</source>
        <translation>
            <numerusform>%n 个错误</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n 个警告</numerusform>
        </translation>
    </message>
    <message>
        <source>No problems</source>
        <translation>没有问题</translation>
    </message>
</context>
<context>
    <name>spacetow::TagGrid</name>
    <message>
        <source>everything</source>
        <translation>一切</translation>
    </message>
    <message>
        <source>New tag</source>
        <translation>新建标签</translation>
    </message>
    <message>
        <source>Name another of the 32 tags</source>
        <translation>再命名 32 个标签中的一个</translation>
    </message>
    <message>
        <source>%1 – double-click or F2 to rename, right-click for more</source>
        <translation>%1 – 双击或按 F2 重命名，右击查看更多</translation>
    </message>
    <message>
        <source>everything except</source>
        <translation>一切，除了</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later, but for those crossed out; click for everything</source>
        <translation>接触任何有标签的物体，包括以后新建的标签，划去的除外；单击改为一切</translation>
    </message>
    <message>
        <source>Touches whatever has a tag, also tags that are made later; click for nothing, click a tag to leave it out</source>
        <translation>接触任何有标签的物体，包括以后新建的标签；单击改为无，单击某个标签可将其排除</translation>
    </message>
    <message>
        <source>Touches the marked tags only; click for everything</source>
        <translation>仅接触已标记的标签；单击改为一切</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>颜色(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>选择所有带此标签的对象(&amp;S)</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>“%1”的颜色</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名称</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixPanel</name>
    <message>
        <source>Name of the tag</source>
        <translation>标签名称</translation>
    </message>
    <message>
        <source>&amp;Select All with This Tag</source>
        <translation>选择所有带此标签的对象(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>重命名(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Color…</source>
        <translation>颜色(&amp;C)…</translation>
    </message>
    <message>
        <source>Color of “%1”</source>
        <translation>“%1”的颜色</translation>
    </message>
</context>
<context>
    <name>spacetow::TagMatrixView</name>
    <message>
        <source>Tag matrix</source>
        <translation>标签矩阵</translation>
    </message>
    <message>
        <source>No object is “%1” or “%2”.</source>
        <translation>没有对象属于“%1”或“%2”。</translation>
    </message>
    <message>
        <source>“%1” and “%2” pass through each other.</source>
        <translation>“%1”和“%2”互相穿过。</translation>
    </message>
    <message>
        <source>“%1” and “%2” touch each other.</source>
        <translation>“%1”和“%2”互相接触。</translation>
    </message>
    <message>
        <source>Some that are “%1” and “%2” touch each other.</source>
        <translation>部分属于“%1”和“%2”的对象互相接触。</translation>
    </message>
    <message>
        <source>The rules of the game say so.</source>
        <translation>由游戏规则决定。</translation>
    </message>
    <message numerus="yes">
        <source>%n objects are “%1”; double-click to select them, right-click for more</source>
        <translation>
            <numerusform>%n 个对象属于“%1”；双击选择它们，右击查看更多</numerusform>
        </translation>
    </message>
    <message>
        <source>They did touch in the last run.</source>
        <translation>它们在上次运行中发生了接触。</translation>
    </message>
    <message>
        <source>They met in the last run, and passed through each other.</source>
        <translation>它们在上次运行中相遇，并互相穿过。</translation>
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
        <translation>时间流逝的速度</translation>
    </message>
</context>
<context>
    <name>spacetow::TimelineScale</name>
    <message>
        <source>Touch</source>
        <translation>接触</translation>
    </message>
    <message>
        <source>Payload taken in tow</source>
        <translation>开始拖曳载荷</translation>
    </message>
    <message>
        <source>Payload let go</source>
        <translation>松开载荷</translation>
    </message>
    <message>
        <source>Crash</source>
        <translation>坠毁</translation>
    </message>
    <message>
        <source>New attempt</source>
        <translation>新的尝试</translation>
    </message>
    <message>
        <source>Win</source>
        <translation>胜利</translation>
    </message>
    <message>
        <source>Edit of the level</source>
        <translation>编辑关卡</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间轴</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1, at %2</source>
        <translation>%1，%2</translation>
    </message>
    <message>
        <source>The selected body touches something</source>
        <translation>所选物体接触到某物</translation>
    </message>
    <message>
        <source>The selected body parts from something</source>
        <translation>所选物体与某物分离</translation>
    </message>
    <message>
        <source>Dashed on the canvas: what was to come before the run was changed. Without a ship these are the ways of the selected body and of up to %1 others.</source>
        <translation>画布上的虚线：更改运行之前原本会发生的情况。没有飞船时，这是所选物体以及最多 %1 个其他物体的路径。</translation>
    </message>
</context>
<context>
    <name>spacetow::TransformBar</name>
    <message>
        <source>Transform</source>
        <translation>变换</translation>
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
        <translation>宽度</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Turn by</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>Relative</source>
        <translation>相对</translation>
    </message>
    <message>
        <source>Move by metres and scale by percent instead of to a place and size</source>
        <translation>按米移动、按百分比缩放，而不是设定位置和大小</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Close this bar (Escape)</source>
        <translation>关闭此栏 (Esc)</translation>
    </message>
    <message>
        <source>That would leave the map, which ends %1 m from the origin.</source>
        <translation>这会超出地图，地图边界距原点 %1 m。</translation>
    </message>
</context>
<context>
    <name>spacetow::WelcomePage</name>
    <message>
        <source>Welcome</source>
        <translation>欢迎</translation>
    </message>
    <message>
        <source>Draw a cave, and fly your load out of it.</source>
        <translation>画一个洞穴，把载荷从中运出。</translation>
    </message>
    <message>
        <source>&amp;New Level</source>
        <translation>新建关卡(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Recent levels</source>
        <translation>最近的关卡</translation>
    </message>
    <message>
        <source>Levels that come with the program; what you open is a copy</source>
        <translation>程序自带的关卡；打开的是副本</translation>
    </message>
    <message>
        <source>&amp;Show this page at start and when the last level is closed</source>
        <translation>启动时和关闭最后一个关卡时显示此页(&amp;S)</translation>
    </message>
    <message>
        <source>Sandbox</source>
        <translation>沙盒</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>关卡</translation>
    </message>
    <message>
        <source>Sandboxes: each shows one thing that the physics does, and says what to try</source>
        <translation>沙盒：每个展示一种物理现象，并提示可以尝试什么</translation>
    </message>
</context>
<context>
    <name>spacetow::ZoomField</name>
    <message>
        <source>Zoom</source>
        <translation>缩放</translation>
    </message>
    <message>
        <source>Zoom: type a percentage, or choose one; Ctrl+0 shows the original size</source>
        <translation>缩放：输入或选择百分比；Ctrl+0 显示原始大小</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
</TS>
