/** Missions: the plans that can be started, the monitor of those that run, their interrupts and who has which tasks. */
@NullMarked
package org.sami.crw.gui.mission;

import org.jspecify.annotations.NullMarked;
