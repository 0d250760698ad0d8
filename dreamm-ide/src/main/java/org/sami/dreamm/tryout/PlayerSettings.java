package org.sami.dreamm.tryout;

import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.ScrolledPanel;

/**
 * With how many robots a plan is tried, how many locations are given, and who answers by itself: in a row behind the buttons, or, where that
 * has no room for it, one below another in a panel of its own. On the event thread.
 */
final class PlayerSettings {
    private static final String HIGH = "hmin 32";

    private final TryOut tryOut;
    private final JLabel robotsLabel = new JLabel("Robots");
    private final JLabel locationsLabel = new JLabel("Locations");
    private final JSpinner robots;
    private final JSpinner locations;
    private final JCheckBox operator = new JCheckBox();
    private final JCheckBox answering = new JCheckBox();
    private final JPanel row =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 6 0", "[][]12[][]12[][]push", "[]"));
    private final ScrolledPanel column =
            new ScrolledPanel(new MigLayout("novisualpadding, insets 8 12 8 12, gap 8 4, wrap 2", "[][grow]", "[]"));
    private final JScrollPane pane = column.inPane();

    PlayerSettings(TryOut tryOut) {
        this.tryOut = tryOut;
        robots = new JSpinner(new SpinnerNumberModel(tryOut.robots(), 0, TryOut.MOST_ROBOTS, 1));
        locations = new JSpinner(new SpinnerNumberModel(tryOut.locations(), 1, TryOut.MOST_LOCATIONS, 1));
        robotsLabel.setLabelFor(robots);
        robotsLabel.setDisplayedMnemonic('b');
        robots.setName("try-robots");
        robots.setToolTipText("With how many robots the next run begins");
        robots.addChangeListener(e -> tryOut.setRobots((Integer) robots.getValue()));
        locationsLabel.setLabelFor(locations);
        locationsLabel.setDisplayedMnemonic('l');
        locations.setName("try-locations");
        locations.setToolTipText("How many locations the operator gives by himself where some are asked for");
        locations.addChangeListener(e -> tryOut.setLocations((Integer) locations.getValue()));
        operator.setName("try-operator-answers");
        operator.setToolTipText(
                "Step and Run let an operator answer that says yes, chooses all and takes what is proposed");
        operator.addActionListener(e -> tryOut.setMockOperator(operator.isSelected()));
        answering.setName("try-robots-answer");
        answering.setToolTipText("Step and Run let robots and services answer that all went well, with sample values");
        answering.addActionListener(e -> tryOut.setMockRobots(answering.isSelected()));
        operator.setOpaque(false);
        answering.setOpaque(false);
        row.setOpaque(false);
        row.setName("try-settings-row");
        column.setName("try-settings");
        inRow(false);
        refresh();
    }

    /** All of them in a row. */
    JPanel row() {
        return row;
    }

    /** One below another. */
    JComponent column() {
        return pane;
    }

    /** Puts them into the row. */
    void inRow(boolean brief) {
        operator.setText(brief ? "Operator" : "Operator answers");
        answering.setText(brief ? "Robots" : "Robots answer");
        if (robots.getParent() != row) {
            row.add(robotsLabel);
            row.add(robots, HIGH);
            row.add(locationsLabel);
            row.add(locations, HIGH);
            row.add(operator);
            row.add(answering);
        }
    }

    /** Puts them into the column. */
    void inColumn() {
        operator.setText("Operator answers");
        answering.setText("Robots answer");
        if (robots.getParent() != column) {
            column.add(robotsLabel);
            column.add(robots, HIGH);
            column.add(locationsLabel);
            column.add(locations, HIGH);
            column.add(operator, "span 2");
            column.add(answering, "span 2");
        }
    }

    /** Shows who answers by itself now. */
    void refresh() {
        operator.setSelected(tryOut.isMockOperator());
        answering.setSelected(tryOut.isMockRobots());
    }
}
