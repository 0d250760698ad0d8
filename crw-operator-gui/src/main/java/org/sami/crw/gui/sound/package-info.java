/** How alarms are heard: which tone, how often, and the machine's loudspeaker. Does not belong here: what an alarm is ({@code org.sami.crw.operator}). */
@NullMarked
package org.sami.crw.gui.sound;

import org.jspecify.annotations.NullMarked;
