/** How alarms are heard: which tone, how often, and the machine's loudspeaker. Does not belong here: what an alarm is ({@code org.sami.crw.operator}). */
package org.sami.crw.gui.sound;
