package org.sami.spn.model;

/** In which drawing mode an element was created and is shown (thesis 5.1, Figure 5.2). No meaning at run time. */
public enum Mode {
    NOMINAL,
    RECOVERY
}
