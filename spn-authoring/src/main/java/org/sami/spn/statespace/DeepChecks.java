package org.sami.spn.statespace;

import java.util.List;

/** The deep checks that there are. */
public final class DeepChecks {
    /** In the order in which they are offered; the first asks what all others ask. */
    public static final List<DeepCheck> ALL = EveryQuestion.withItsParts();

    private DeepChecks() {}
}
