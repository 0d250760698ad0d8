/** The strip at the top: missions, boats, links at a glance, the clock, alarms, the fleet stop. */
@NullMarked
package org.sami.crw.gui.status;

import org.jspecify.annotations.NullMarked;
