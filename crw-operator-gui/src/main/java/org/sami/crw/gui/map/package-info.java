/** The map: what the map's model has, as layers of the ui-kit's map; choosing boats on it, and sending them somewhere by hand. */
@NullMarked
package org.sami.crw.gui.map;

import org.jspecify.annotations.NullMarked;
