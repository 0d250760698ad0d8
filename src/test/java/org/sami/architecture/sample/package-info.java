/** Classes that break a rule about windows, each one rule: the rules must notice them. */
package org.sami.architecture.sample;
