/**
 * The boat's own log on its disk: what it has executed and answered, and in which start of its server.
 *
 * <p>Here belongs how that is written and read back. What the boat takes back of it after a restart is the matter of {@link
 * org.sami.boat.server.BoatServer#restore}. Java 8 level.
 */
package org.sami.boat.server.log;
