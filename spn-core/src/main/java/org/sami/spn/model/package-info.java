/** The definition of a plan. */
package org.sami.spn.model;
