package org.sami.crw.gui.value;

import org.sami.crw.gui.context.OperatorContext;
import org.sami.spn.component.ComponentChoice;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.ValueContext;
import org.sami.ui.value.ValueEditors;

/** Makes the editors with which values are given in a session. */
public final class SessionEditors {
    private SessionEditors() {}

    /**
     * The editors of a session. On the event thread.
     *
     * @param choice which component fits a value
     * @param maps on which places are drawn
     */
    public static ValueEditors of(OperatorContext context, ComponentChoice choice, MapMaker maps) {
        return new ValueEditors(
                choice, new ValueContext(context.vocabulary().types(), new SessionNames(context), maps));
    }
}
