/**
 * Benchmarks of the reading of MAVLink, run by {@code ./gradlew benchmark}.
 *
 * <p>Belongs here: measurements and the main program that writes their table and file. Does not belong here: tests.
 */
package org.sami.mavlink.bench;
