package org.sami.ui.value;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JComponent;
import org.sami.spn.value.Value;
import org.sami.ui.geo.GeoSketch;

/**
 * Shows one value and lets it be given. What it holds now, or why it holds none yet, is {@link #entry}; the reason also stands at the
 * field. Lives on the event thread.
 */
public abstract class ValueEditor {
    private final ValueField field;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private boolean touched;
    private boolean showing;

    protected ValueEditor(ValueField field) {
        this.field = Objects.requireNonNull(field, "field");
    }

    /** What this is for. */
    public final ValueField field() {
        return field;
    }

    /** What is put into a window; always the same one. */
    public abstract JComponent component();

    /** Where the keyboard's focus goes first. */
    public abstract JComponent focusTarget();

    /** What the field holds now. */
    public abstract Entry entry();

    /** What is drawn here, so that it can be drawn on another map as well; empty where nothing is. */
    public Optional<GeoSketch> sketch() {
        return Optional.empty();
    }

    /**
     * Shows the map that it has of its own, or leaves it out where the same is drawn on a large one. Does nothing where there is none.
     *
     * @param shown whether it is shown
     */
    public void useOwnMap(boolean shown) {}

    /** Shows a value of the field's type. */
    protected abstract void display(Value value);

    /** Shows no value. */
    protected abstract void displayNothing();

    /** Whether the value can be given here, or is only shown. */
    public abstract void setEditable(boolean editable);

    /**
     * Shows a value of the field's type; what was typed before is gone, and the operator has touched nothing.
     *
     * @throws RuntimeException if it is a value of another type
     */
    public final void show(Value value) {
        showing = true;
        try {
            display(value);
        } finally {
            showing = false;
        }
        untouch();
    }

    /** Shows no value; the operator has touched nothing. */
    public final void clear() {
        showing = true;
        try {
            displayNothing();
        } finally {
            showing = false;
        }
        untouch();
    }

    /** What is shown now was shown by the program: the operator has touched nothing. */
    final void untouch() {
        touched = false;
        tell();
    }

    /** Whether the operator has changed something since a value was last shown: such a field must not be replaced. */
    public final boolean isTouched() {
        return touched;
    }

    /** Adds a listener that is called after each change of the entry, on the event thread. */
    public final void addListener(Runnable listener) {
        listeners.add(Objects.requireNonNull(listener, "listener"));
    }

    /** To be called after each change of what the field holds. */
    protected final void changed() {
        if (!showing) {
            touched = true;
            tell();
        }
    }

    /** Leaves out what is missing, where the caller shows it: the same text must not appear twice. */
    void leaveMessage() {}

    /** Puts the reason at the field after a change; called before the listeners. */
    protected void refresh() {}

    private void tell() {
        refresh();
        listeners.forEach(Runnable::run);
    }
}
