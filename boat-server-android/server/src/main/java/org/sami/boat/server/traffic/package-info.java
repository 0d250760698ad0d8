/**
 * Other boats near this one, and how this boat gives way to them (docs/decisions, 0320). Not here: the reports of other boats, which the base sends
 * over the link, and the control of the motors.
 */
package org.sami.boat.server.traffic;
