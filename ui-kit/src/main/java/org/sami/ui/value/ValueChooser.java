package org.sami.ui.value;

import java.util.List;
import java.util.OptionalInt;

/** An editor that offers values, of which some are chosen. Options are numbered from 0 here, and from 1 where people read it. */
public abstract class ValueChooser extends ValueEditor {
    protected ValueChooser(ValueField field) {
        super(field);
    }

    /** How many are offered. */
    public abstract int options();

    /** The chosen ones, in the order of the offer. */
    public abstract List<Integer> chosen();

    /** Chooses an option as the operator does: of several that may be chosen, one that is chosen already is chosen no longer. */
    public abstract void choose(int option);

    /** Changes the text next to an option, where there is room for it. */
    void showDetail(int option, String detail) {}

    /** Shows options as chosen before the operator has touched anything. */
    final void propose(List<Integer> options) {
        displayNothing();
        options.forEach(this::mark);
        untouch();
    }

    /** Marks an option as chosen. */
    abstract void mark(int option);

    /** The option that is looked at, from 0, where each has something that a map can show; it need not be chosen. */
    OptionalInt looked() {
        return OptionalInt.empty();
    }

    /** Looks at an option, which chooses none. */
    void look(int option) {}

    /** Calls a listener when another option is looked at. */
    void onLooked(Runnable listener) {}
}
