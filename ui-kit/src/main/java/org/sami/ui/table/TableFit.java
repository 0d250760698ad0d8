package org.sami.ui.table;

import java.awt.Container;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.sheet.WindowSheet;

/** Makes a table in a sheet as high as its rows, as far as the window has room. On the event thread. */
public final class TableFit {
    private final Container form;
    private final MigLayout layout;
    private final RowTable<?> table;
    private final int leastPx;
    private final int leastRows;
    private String fitted = "";

    /**
     * For a table that lies in a form.
     *
     * @param layout the form's
     * @param leastPx how low it may become, in pixels
     * @param leastRows for how many rows it has room, however few there are
     */
    public TableFit(Container form, MigLayout layout, RowTable<?> table, int leastPx, int leastRows) {
        this.form = form;
        this.layout = layout;
        this.table = table;
        this.leastPx = leastPx;
        this.leastRows = leastRows;
    }

    /**
     * Fits the table to its rows, and the sheet to the form.
     *
     * @param words what stands below the table: other words may need other room
     */
    public void fit(int rows, String words) {
        String height = "growx, h " + leastPx + ":" + table.heightOf(Math.max(leastRows, rows) + 1) + "px:";
        boolean grows = !height.equals(layout.getComponentConstraints(table));
        layout.setComponentConstraints(table, height);
        if (grows || !words.equals(fitted)) {
            fitted = words;
            form.revalidate();
            WindowSheet.find(form).ifPresent(WindowSheet::fit);
        }
    }
}
