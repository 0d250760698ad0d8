package org.sami.crw.gui.value;

import javax.swing.JComponent;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.FoldingPanel;

/** A list and what is chosen in it: side by side, or one below the other where the panel is narrow. */
public final class SidesPanel extends FoldingPanel {
    private static final int ROOM = 520;
    private static final String LAYOUT = "novisualpadding, insets 0, gap 0, fill";

    private final transient MigLayout layout;

    public SidesPanel(JComponent list, JComponent chosen) {
        super(new MigLayout(LAYOUT, "[40%,fill][60%,fill]", "[grow,fill]"));
        layout = (MigLayout) getLayout();
        add(list, "wmin 120, hmin 120");
        add(chosen, "wmin 160");
        foldBelowWidth(ROOM, this::stack);
    }

    private void stack(boolean narrow) {
        layout.setLayoutConstraints(LAYOUT + (narrow ? ", wrap 1" : ""));
        layout.setColumnConstraints(narrow ? "[grow,fill]" : "[40%,fill][60%,fill]");
        layout.setRowConstraints(narrow ? "[40%,fill][60%,fill]" : "[grow,fill]");
        revalidate();
    }
}
