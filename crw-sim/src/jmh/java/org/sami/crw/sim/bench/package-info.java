/**
 * Benchmarks of the boat link, run by {@code ./gradlew benchmark}: the codec alone, a whole fleet behind TCP, a long upload.
 *
 * <p>Belongs here: measurements and the main program that writes their table and file. Does not belong here: tests.
 */
package org.sami.crw.sim.bench;
