package org.sami.dreamm.context;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/** What the author has typed and the project has not got yet. Who shows fields says here how it is given. On the event thread. */
public final class TypedText {
    private final List<Runnable> givers = new ArrayList<>();

    /**
     * Fields of a panel.
     *
     * @param give makes the edits for what stands in them; nothing where nothing was typed
     */
    public void add(Runnable give) {
        givers.add(Objects.requireNonNull(give, "give"));
    }

    /** Makes the edits for all that was typed, as if its fields had been left. */
    public void give() {
        givers.forEach(Runnable::run);
    }
}
