/**
 * Benchmarks of vehicles that speak MAVLink, run by {@code ./gradlew benchmark}: what they cost a base.
 *
 * <p>Belongs here: measurements and the main program that writes their table and file. Does not belong here: tests.
 */
package org.sami.crw.mavlink.bench;
