<tileset name="t" tilewidth="8" tileheight="8" tilecount="2" columns="2">
 <tile id="1"><objectgroup><object x="0" y="4" width="8" height="4"/></objectgroup></tile>
</tileset>
