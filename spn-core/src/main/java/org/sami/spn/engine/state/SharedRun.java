package org.sami.spn.engine.state;

import java.util.ArrayList;
import java.util.List;

/** The static instance on a place, with its returns that no firing has used, oldest first. */
public final class SharedRun {
    /** None: what most places have. */
    public static final SharedRun[] NONE = {};

    public final Instance instance;
    public final List<Return> returns = new ArrayList<>(0);

    public SharedRun(Instance instance) {
        this.instance = instance;
    }
}
