/**
 * The boat's own log on its disk: the commands it has executed, its answers, and the starts of its server.
 *
 * <p>Here: writing and reading it. What the boat restores from it after a restart is decided by {@link org.sami.boat.server.BoatServer#restore}. Java 8
 * level.
 */
package org.sami.boat.server.log;
