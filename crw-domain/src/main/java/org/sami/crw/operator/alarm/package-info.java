/**
 * What is wrong with boats: alarms, and the checks that find them in what is known of positions, paths, batteries and links.
 *
 * <p>Belongs here: one class for each check, without threads and clocks. Does not belong here: how long an alarm stands, who has
 * acknowledged it ({@code org.sami.crw.operator.AlarmModel}), how it sounds (the windows).
 */
package org.sami.crw.operator.alarm;
