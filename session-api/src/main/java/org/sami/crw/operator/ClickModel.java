package org.sami.crw.operator;

import java.util.List;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/** How many clicks the operator has made in the session (docs/clicks.md). */
public final class ClickModel extends Model<Long> {
    private ClickCount count = new ClickCount();

    ClickModel() {
        super(0L);
    }

    /** Starts counting from zero. */
    void clear() {
        count = new ClickCount();
        change();
    }

    void apply(Input input, List<Effect> effects) {
        count.count(input, effects);
        if (count.clicks() != snapshot()) {
            change();
        }
    }

    /** Clicks so far. From any thread. */
    public long clicks() {
        return snapshot();
    }

    @Override
    Long take() {
        return count.clicks();
    }
}
