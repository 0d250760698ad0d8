/** Benchmarks of the analysis of nets. */
package org.sami.petri.bench;
