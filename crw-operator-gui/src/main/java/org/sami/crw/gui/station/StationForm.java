package org.sami.crw.gui.station;

import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.value.WrappedText;

/** Asks where the simulated boats are to be shown, and says whether a ground station answers. They stay shown when it is closed. On the event thread. */
public final class StationForm extends JPanel {
    private static final int POLL_MS = 500; // whether a station answers changes by itself

    private final OperatorContext context;
    private final StationLinks show;
    private final JTextField address = new JTextField(28);
    private final JButton start = new JButton("Show");
    private final JButton stop = new JButton("Show no longer");
    private final WrappedText said = new WrappedText("");
    private Optional<String> wrong = Optional.empty();

    /** A form over what is shown now. */
    public StationForm(OperatorContext context, StationLinks show) {
        super(new MigLayout("novisualpadding, insets 8 12 12 12, gap 8, fillx, wrap 2", "[grow,fill][]"));
        this.context = context;
        this.show = show;
        setName("ground-station-form");
        JLabel label = new JLabel("Address of the ground station (QGroundControl, Mission Planner, MAVProxy)");
        label.setLabelFor(address);
        address.setName("ground-station-address");
        address.setText(show.where().orElse(StationLinks.USUAL));
        start.setName("ground-station-do");
        start.addActionListener(e -> start());
        stop.setName("ground-station-stop");
        stop.setToolTipText("End the links to ground stations; boats that one commands do what is set for a lost link");
        stop.addActionListener(e -> stop());
        said.setName("ground-station-said");
        WrappedText rule = new WrappedText("Each boat is a vehicle of its own there. This session keeps the command: a"
                + " station that orders something is refused, and you are asked whether to hand over. A stop is always"
                + " obeyed.");
        rule.setName("ground-station-rule");
        rule.setColor(SemanticColor.MUTED);
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ENTER"), "show");
        getActionMap().put("show", new Command("ground-station-enter", "Show", this::start));
        add(label, "span");
        add(address, "hmin 40");
        add(start, "hmin 40");
        add(said, "growx, hmin 60, wmin 0");
        add(stop, "hmin 40");
        add(rule, "span, growx, wmin 0");
        Timer look = new Timer(POLL_MS, e -> refresh());
        addHierarchyListener(event -> {
            if (isShowing()) {
                look.start();
            } else {
                look.stop();
            }
        });
        refresh();
    }

    private void start() {
        String text = address.getText().strip();
        wrong = text.isEmpty()
                ? Optional.of("Type the address, such as " + StationLinks.USUAL)
                : StationLinks.whyNot(text);
        if (wrong.isEmpty()) {
            show.start(text);
            context.notices().show("simulated boats are shown at " + text);
        }
        refresh();
    }

    private void stop() {
        wrong = Optional.empty();
        show.stop();
        context.notices().show("simulated boats are shown to no ground station any longer");
        refresh();
        address.requestFocusInWindow();
    }

    /** Says what is shown, or what is wrong with the address. */
    void refresh() {
        stop.setVisible(show.where().isPresent());
        String text = wrong.map(why -> "▲ " + why).or(show::words).orElse("");
        if (!said.getText().equals(text)) {
            said.setText(text);
            revalidate();
        }
        said.setColor(wrong.isPresent() ? SemanticColor.WARNING : SemanticColor.TEXT);
    }
}
