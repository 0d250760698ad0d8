package org.sami.spn.model;

/** Whether a transition fires per occurrence or once with all (R-PEND-5, R-PEND-7). */
public enum WaitFor {
    EACH,
    ALL
}
