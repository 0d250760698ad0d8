/** Measures DREAMM. */
package org.sami.dreamm.bench;
