/** How long it takes to paint what windows show most. */
package org.sami.ui.bench;
