/**
 * What editors of values need of a session: the boats, tasks and plans that can be chosen by name, and maps that show where boats are. Does
 * not belong here: the editors themselves ({@code org.sami.ui.value}).
 */
@NullMarked
package org.sami.crw.gui.value;

import org.jspecify.annotations.NullMarked;
