/**
 * What benchmarks of all modules measured: one number each, printed as a table and put into one file.
 *
 * <p>Belongs here: numbers and their file. Does not belong here: how anything is measured.
 */
package org.sami.figures;
