package org.sami.crw.gui.map;

import java.awt.BorderLayout;
import java.awt.Cursor;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.BorderFactory;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.Timer;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.RobotIcons;
import org.sami.crw.gui.context.SessionWays;
import org.sami.crw.gui.context.UseWatch;
import org.sami.crw.gui.decision.DecisionMap;
import org.sami.crw.operator.MapModel;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.map.LayerState;
import org.sami.crw.operator.map.MapSnapshot;
import org.sami.crw.operator.map.PlacesInText;
import org.sami.crw.operator.map.ShownPart;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.palette.SemanticColor;
import org.sami.spn.engine.EngineView;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.map.MapClick;
import org.sami.ui.map.MapKey;
import org.sami.ui.map.MapListener;
import org.sami.ui.map.MapView;
import org.sami.ui.sheet.FileSheet;
import org.sami.ui.value.PlacesOnMap;
import org.sami.ui.window.WindowSettings;

/** The map of the session: boats, ways, areas, measured fields; boats are chosen on it and sent somewhere. */
public final class MapPanel extends JPanel {
    private static final int LOW = 330;
    private static final int SHOW_MS =
            50; // boats of a large fleet are seen at all times: what comes meanwhile is shown together

    private final OperatorContext context;
    private final MapView view = new MapView();
    private final MapFeed feed;
    private final GuidedMode guided;
    private final CommandRow tools = new CommandRow();
    private final Timer pace = new Timer(SHOW_MS, e -> refresh());
    private final FirstView firstView;
    private final JLabel consequence = new JLabel(" ");
    private final PlacesOnMap preview;
    private final NamedPlaces named = new NamedPlaces(view, "message");
    private final BaseMapMenu baseMaps = new BaseMapMenu(view);
    private final MapPen pen;
    private boolean pointing;
    private long partShown;

    /** The map of a session. */
    public MapPanel(OperatorContext context) {
        super(new BorderLayout());
        this.context = context;
        feed = new MapFeed(context, view.layers());
        guided = new GuidedMode(context);
        preview = new PlacesOnMap(view, "preview", context.marks()::of);
        pen = new MapPen(view, () -> pointing, this::placeOf, context::say);
        firstView = new FirstView(view, pen::isFree);
        MapPen.onEscape(this, this::escape);
        addTools();
        consequence.setName("boats-consequence");
        int inset = Look.px(Spacing.NORMAL);
        consequence.setBorder(BorderFactory.createEmptyBorder(0, inset, inset / 2, inset));
        JPanel top = new JPanel(new BorderLayout());
        top.add(tools);
        top.add(consequence, BorderLayout.SOUTH);
        add(top, BorderLayout.NORTH);
        view.setBorder(
                new FleetStopFrame(() -> context.models().fleetStop().snapshot().isOfFleet()));
        context.models().fleetStop().addListener(state -> view.repaint());
        add(view);
        view.addMapListener(new MapListener() {
            @Override
            public void clicked(MapClick click) {
                MapPanel.this.clicked(click);
            }

            @Override
            public void boxed(List<String> items) {
                if (!pen.takes(items)) {
                    context.boats().select(boatsOf(items));
                }
            }

            @Override
            public void problem(String text) {
                context.notices().refused(text);
            }
        });
        UseWatch.on(view.canvas(), view.canvas(), this::tellUse, map()::focus);
        context.boats().addListener(() -> refresh());
        pace.setRepeats(false);
        map().addListener(this::show);
        feed.show(map().snapshot());
        show(map().snapshot());
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (preview != null) {
            tellConsequence(); // its colour is the theme's
        }
    }

    private MapModel map() {
        return context.models().map();
    }

    /** The model knows what the operator sees, and that the map is in use. */
    private void tellUse() {
        MapFrame frame = view.frame();
        GeoPoint northWest = frame.point(0, 0);
        GeoPoint southEast = frame.point(frame.width(), frame.height());
        map().moved(southEast.latDeg(), northWest.lonDeg(), northWest.latDeg(), southEast.lonDeg());
    }

    private void addTools() {
        tool("boats-go", "Go here", "ctrl G", "go-to", this::beginPointing);
        tool("boats-hold", "Hold", "ctrl H", RobotIcons.hold(context.robots()), () -> {
            context.notices().show(guided.consequence());
            guided.hold();
        });
        tool("boats-home", "Return home", "ctrl shift H", "home", this::goHome);
        tool("boats-give-back", "Back to missions", "ctrl shift B", "resend", guided::giveBack);
        Command layers = new Command(
                        "map-layers", "Layers", () -> layersMenu().show(tools, tools.getWidth() / 2, tools.getHeight()))
                .withKey("ctrl L")
                .withIcon("layers");
        tools.right(new CommandButton(context.commands().add(layers)));
        Command base = new Command("map-base", "Base map…", this::openBaseMap)
                .withKey("alt shift B")
                .withIcon("map");
        tools.right(new CommandButton(context.commands().add(base)));
        context.commands().add(view.stopReading());
        context.commands().add(baseMaps.toggle());
        context.commands().add(new SimulatedBoatAdder(context, this::middle).command());
        view.command(MapKey.MEASURE).withKey("ctrl shift L").withIcon("measure");
        view.command(MapKey.FIT).withKey("ctrl shift F").withIcon("fit");
        view.commands().forEach(context.commands()::add);
    }

    private GeoPoint middle() {
        MapFrame frame = view.frame();
        return frame.point(frame.width() / 2.0, frame.height() / 2.0);
    }

    private void tool(String id, String title, String key, String icon, Runnable run) {
        Command command = context.commands()
                .add(new Command(id, title, run).withKey(key).withIcon(icon).unless(this::whyNotGuided));
        context.boats().addListener(command::refresh);
        tools.left(new CommandButton(command));
    }

    private Optional<String> whyNotGuided() {
        return context.boats().boats().isEmpty()
                ? Optional.of("select boats first, by a click or a box with Shift held")
                : Optional.empty();
    }

    private Optional<GeoPoint> placeOf(String boat) {
        return context.models().fleet().boat(boat).flatMap(BoatSnapshot::pose).map(BoatPose::position);
    }

    /** Ends what waits for a click: sending boats somewhere first, then the pen. */
    private void escape() {
        if (pointing) {
            endPointing();
            context.notices().show("No boat is sent");
        } else {
            pen.escape();
        }
    }

    private void endPointing() {
        pointing = false;
        view.canvas().setCursor(Cursor.getDefaultCursor());
    }

    private void beginPointing() {
        pen.interrupt();
        pointing = true;
        view.canvas().requestFocusInWindow(); // Escape leaves it
        view.canvas().setCursor(Cursor.getPredefinedCursor(Cursor.CROSSHAIR_CURSOR));
        context.notices().show("Click where to go. " + guided.consequence());
    }

    private void clicked(MapClick click) {
        if (pointing) {
            endPointing();
            guided.goTo(click.at());
            return;
        }
        if (pen.takes(click)) {
            return;
        }
        Set<String> next =
                new LinkedHashSet<>(click.additive() ? context.boats().boats() : List.of());
        next.addAll(boatsOf(click.item().stream().toList()));
        context.boats().select(next);
    }

    private List<String> boatsOf(List<String> items) {
        return items.stream()
                .filter(item -> context.models().fleet().boat(item).isPresent())
                .toList();
    }

    private void goHome() {
        context.shown().ask(EngineView::globals).thenAccept(globals -> {
            Optional<GeoPoint> home = Optional.ofNullable(globals.get(GuidedMode.HOME))
                    .filter(GeoPoint.class::isInstance)
                    .map(GeoPoint.class::cast);
            context.notices().show(guided.consequence());
            guided.goHome(home);
        });
    }

    private JPopupMenu layersMenu() {
        JPopupMenu menu = new JPopupMenu();
        for (LayerState state : map().snapshot().layers()) {
            JCheckBoxMenuItem item =
                    new JCheckBoxMenuItem(context.say(state.layer().label()), state.on());
            item.setName("layer-" + state.layer().label().replace(' ', '-'));
            item.setToolTipText(context.say(state.why()));
            item.addActionListener(e -> map().show(state.layer(), Optional.of(item.isSelected())));
            menu.add(item);
        }
        baseMaps.addTo(menu);
        return menu;
    }

    private void openBaseMap() {
        new FileSheet("base-map-file", "Open a base map (.mbtiles, .geojson)").open(this, view::openBaseMap);
    }

    /** Shows the model as it is now; to be called a few times a second, as ages change by themselves. */
    public void refresh() {
        tellConsequence();
        feed.show(map().snapshot());
        pen.refresh();
    }

    private void show(MapSnapshot now) {
        pace.start();
        firstView.look(now);
        now.view().filter(part -> part.number() > partShown).ifPresent(this::showPart);
    }

    private void showPart(ShownPart part) {
        partShown = part.number();
        view.fit(new GeoBounds(part.southDeg(), part.westDeg(), part.northDeg(), part.eastDeg()));
        if (!part.why().isEmpty()) {
            context.notices().show(part.why());
        }
    }

    /** Shows which boats a command concerns and what waits meanwhile, before it is given. */
    private void tellConsequence() {
        boolean none = context.boats().boats().isEmpty();
        String text = none
                ? context.say("Select boats to send them without a plan: a click, or a box with Shift held.")
                : context.say(guided.consequence());
        consequence.setVisible(
                !none || getHeight() >= Look.px(LOW)); // a hint that costs a fifth of a low map helps nobody
        consequence.setText(text);
        consequence.setToolTipText(text);
        consequence.setFont(Fonts.small());
        LookColors.foreground(consequence, none ? SemanticColor.MUTED : SemanticColor.ACCENT);
    }

    /** Draws the values with which a mission is about to start, and sees to it that they can be seen; none = nothing is about to start. */
    public void preview(List<Value> values) {
        preview.show(values);
        List<GeoPoint> points = new ArrayList<>();
        values.forEach(value -> {
            if (value instanceof GeoPoint point) {
                points.add(point);
            } else if (value instanceof GeoArea area) {
                points.addAll(area.outline());
            } else if (value instanceof GeoPath path) {
                points.addAll(path.points());
            }
        });
        if (!points.stream().allMatch(view.frame()::isShown)) {
            GeoBounds.of(points)
                    .ifPresent(box -> view.fit(
                            FirstView.bounds(map().snapshot()).map(box::with).orElse(box)));
        }
    }

    /** Points at what a message or an alarm speaks of: its boats stand out, and the places that its text names are marked and in view. */
    public void pointAt(List<String> boats, String text) {
        List<GeoPoint> places = PlacesInText.of(text);
        named.show(places);
        tellUse();
        map().pointAt(boats, "");
        if (!places.stream().allMatch(view.frame()::isShown)) {
            GeoBounds.of(places)
                    .ifPresent(box -> view.fit(
                            FirstView.bounds(map().snapshot()).map(box::with).orElse(box)));
        }
    }

    /** Where the shown decision is seen on this map; to be asked for once. */
    public DecisionMap decisionMap() {
        return new DecisionOverlay(
                view,
                context.marks(),
                new SessionWays(context),
                pen,
                () -> firstView.moved(view::fitAll),
                context::say);
    }

    /** Shows the base maps that an earlier window of these settings had, and keeps in them those that this one has. */
    public void rememberBaseMaps(WindowSettings settings) {
        BaseMapMemory.of(view, settings);
    }

    /** Gives another map of the session the base maps that this one shows now. */
    public void giveBaseMaps(MapView other) {
        other.showBaseMapsOf(view);
    }

    /** Gives up its files. */
    public void close() {
        pace.stop();
        view.close();
    }
}
