/** A small vehicle that speaks MAVLink, for tests where no autopilot is there. */
package org.sami.mavlink.testing;
