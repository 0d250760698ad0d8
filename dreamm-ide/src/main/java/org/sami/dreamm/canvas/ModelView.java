package org.sami.dreamm.canvas;

import java.awt.BorderLayout;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.swing.JPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.EditorListener;
import org.sami.spn.model.Plan;
import org.sami.ui.look.IdentityMarks;
import org.sami.ui.net.NetListener;
import org.sami.ui.net.NetView;

/** Shows the net of the open plan. */
public final class ModelView extends JPanel {
    private static final Plan NONE = new Plan(
            "", "", "", List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), Map.of(),
            List.of(), List.of());

    private final transient DreammContext context;
    private final NetView net = new NetView(new IdentityMarks());

    /** The view of a window. */
    public ModelView(DreammContext context) {
        super(new BorderLayout());
        this.context = context;
        add(net);
        context.document().addListener(change -> showPlan());
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                showPlan();
            }

            @Override
            public void modeChanged() {
                net.setMode(context.editor().mode());
            }

            @Override
            public void selectionChanged() {
                net.select(context.editor().selection());
            }

            @Override
            public void highlightChanged() {
                net.highlight(context.editor().highlight());
            }
        });
        net.addNetListener(new NetListener() {
            @Override
            public void selected(Set<String> ids) {
                context.editor().select(ids);
            }
        });
        showPlan();
    }

    private void showPlan() {
        net.show(context.editor().plan().orElse(NONE), context.vocabulary());
    }
}
