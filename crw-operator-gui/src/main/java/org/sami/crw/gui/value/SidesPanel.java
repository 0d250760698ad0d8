package org.sami.crw.gui.value;

import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.Look;

/** A list and what is chosen in it: side by side, or one below the other where the panel is narrow. */
public final class SidesPanel extends JPanel {
    private static final int ROOM = 520;
    private static final String LAYOUT = "novisualpadding, insets 0, gap 0, fill";

    private final MigLayout layout = new MigLayout(LAYOUT, "[40%,fill][60%,fill]", "[grow,fill]");
    private boolean below;

    public SidesPanel(JComponent list, JComponent chosen) {
        setLayout(layout);
        add(list, "wmin 120, hmin 120");
        add(chosen, "wmin 160");
    }

    @Override
    public void doLayout() {
        boolean narrow = getWidth() < Look.px(ROOM);
        if (narrow != below) {
            below = narrow;
            layout.setLayoutConstraints(LAYOUT + (narrow ? ", wrap 1" : ""));
            layout.setColumnConstraints(narrow ? "[grow,fill]" : "[40%,fill][60%,fill]");
            layout.setRowConstraints(narrow ? "[40%,fill][60%,fill]" : "[grow,fill]");
            revalidate();
        }
        super.doLayout();
    }
}
