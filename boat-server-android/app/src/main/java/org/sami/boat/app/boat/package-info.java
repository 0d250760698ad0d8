/**
 * The boat on a phone without Android: its name, files and home, its vehicle, and the server that commands it.
 *
 * <p>Not here: sensors and ports of the phone, the screen. Java 8 level.
 */
package org.sami.boat.app.boat;
