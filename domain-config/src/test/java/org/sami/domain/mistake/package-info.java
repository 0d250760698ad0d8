/**
 * Mistakes that authors make, each as an edit of a right plan and the finding that names it. Checks of single rules are tried in spn-core,
 * on plans that are made for them; here it counts that what goes wrong in real plans is found, and nothing in right ones.
 */
package org.sami.domain.mistake;
