/** The list of boats near, in a sheet of the window: found, connected, checked. What is listed and connected stands in {@code org.sami.crw.session.near}. */
@NullMarked
package org.sami.crw.gui.near;

import org.jspecify.annotations.NullMarked;
