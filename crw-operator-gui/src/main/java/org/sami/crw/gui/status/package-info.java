/** The strip at the top: missions, boats, links at a glance, the clock, alarms, the fleet stop. */
package org.sami.crw.gui.status;
