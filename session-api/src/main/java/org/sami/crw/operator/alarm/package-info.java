/**
 * Alarms about boats, and the checks that find them from positions, paths, batteries and links.
 *
 * <p>Here: one class for each check, without threads and clocks. Not here: the duration and acknowledgement of an alarm ({@code
 * org.sami.crw.operator.AlarmModel}), and its sound (the windows).
 */
@NullMarked
package org.sami.crw.operator.alarm;

import org.jspecify.annotations.NullMarked;
