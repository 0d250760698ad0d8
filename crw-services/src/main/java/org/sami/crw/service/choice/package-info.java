/**
 * How a service chooses among its algorithms: each declares the criteria that it serves, and the markup Optimize names one (thesis
 * 3.1, appendix .2.3).
 *
 * <p>Belongs here: criteria, declarations, the choice by them. Does not belong here: algorithms, problems, markups.
 */
@NullMarked
package org.sami.crw.service.choice;

import org.jspecify.annotations.NullMarked;
