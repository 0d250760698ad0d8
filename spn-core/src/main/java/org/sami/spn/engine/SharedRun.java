package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;

/** The static instance on a place, with its returns that no firing has used, oldest first. */
final class SharedRun {
    final Instance instance;
    final List<Return> returns = new ArrayList<>(0);

    SharedRun(Instance instance) {
        this.instance = instance;
    }

    /** The oldest unused return, or null. */
    Return oldest() {
        return returns.isEmpty() ? null : returns.get(0);
    }
}
