package org.sami.crw.mavlink;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Traffic;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.base.MessagePlan;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.SenderFault;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleId;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import org.sami.spn.protocol.Priority;

/**
 * A vehicle as a boat of the base: what it reports becomes what boats say, and the base's commands go to {@link AutopilotCommands}. It lives as long as its link,
 * over all connections of the base. For the gateway's thread.
 */
final class VehicleBoat implements BaseSession.Boat {
    private static final System.Logger LOG = System.getLogger(VehicleBoat.class.getName());
    private static final long HEARTBEAT_MS = 900; // so that it comes once a second at least
    private static final long TICK_MS = 100;
    private static final long FRESH_MS =
            300; // what is older is passed on no longer: it would hide for a second that the vehicle is silent
    private static final long BATTERY_MS = 10_000;
    private static final double STILL_MPS = 0.1;

    private final String name;
    private final VehicleKind kind;
    private final boolean flies;
    private final ForeignFiles kept;
    private final AutopilotCommands orders;
    private final VehicleSettings settings;
    private final VehiclePerformance performance;
    private final VehicleFence fence;
    private final VehicleAvoidance avoidance;
    private final VehicleCamera camera;
    private final VehicleFiles files;
    private final VehicleCharge charge = new VehicleCharge();
    private final VehicleSensors sensors = new VehicleSensors();
    private final VehicleTargets targets;
    private final OtherController others;
    private final ForeignStart start;
    private final VehicleTexts texts;
    private boolean isReplaced; // another vehicle has its id, and what is kept is that one's
    private Optional<BaseSession> session = Optional.empty();
    private final Set<String> toldOfKeys = new HashSet<>(); // in this session
    private final Set<SenderFault> toldSpeech = EnumSet.noneOf(SenderFault.class); // in this session
    private VehicleSnapshot vehicle;
    private long saidMs; // time of the last telemetry
    private long heardMs; // time of the last vehicle message that was passed on
    private long positionMs; // time of the position in the last telemetry
    private long motionMs; // time of the position that was last passed on to boats near it
    private long beatMs;
    private Optional<BatteryReport> battery = Optional.empty();
    private long batteryMs;
    private long tickMs; // of the last tick
    private String toldProgress = ""; // of a command
    private Progress keptProgress = new Progress("", 0, false);

    VehicleBoat(MavlinkBase base, VehicleSnapshot first, Executor thread, VehicleFiles files, SeenTargets seen) {
        name = "mav" + first.id();
        targets = new VehicleTargets(seen);
        vehicle = first;
        charge.reported(first);
        texts = new VehicleTexts(name);
        start = new ForeignStart(name, first.armed());
        kind = first.kind();
        flies = kind == VehicleKind.COPTER;
        others = new OtherController(new RadioControl(base, first.id(), kind, thread));
        this.files = files;
        kept = new ForeignFiles(name, files, first.number().orElse(""), flies);
        settings = new VehicleSettings(
                base, first.id(), kept.ofStarts(), flies, thread, this::reportSettings, this::alarm);
        performance = new VehiclePerformance(
                base, first.id(), flies, thread, files.consumption(name), counted -> keep(files, counted));
        fence = new VehicleFence(
                base, first.id(), flies, thread, this::alarm, files.fences(name), given -> keepFences(files, given));
        avoidance = new VehicleAvoidance(base, first.id(), thread, this::alarm);
        camera = new VehicleCamera(base, first.id(), thread, this::broadcast, this::reportSettings);
        orders = new AutopilotCommands(
                name,
                base,
                first,
                thread,
                settings,
                performance::waypointRadiusM,
                this::broadcast,
                given -> keep(files, given),
                this::alarm,
                files.read(name));
    }

    private void keep(VehicleFiles files, VehicleFiles.Kept given) {
        if (isReplaced) {
            return;
        }
        try {
            files.write(name, given);
        } catch (IOException e) {
            session.ifPresent(told -> told.alarm("what " + name
                    + " was given cannot be stored on this machine; after a crash the base sends it again: "
                    + e.getMessage()));
        }
    }

    private void keep(VehicleFiles files, VehicleConsumption counted) {
        if (isReplaced) {
            return;
        }
        try {
            files.write(name, counted);
        } catch (IOException e) {
            LOG.log(Level.WARNING, "how far " + name + " drives on its charge is counted anew by the next base", e);
        }
    }

    /** Also while no base is there. */
    private void keep(Progress progress) {
        if (!isReplaced && !progress.equals(keptProgress)) {
            keptProgress = progress;
            try {
                files.write(name, progress);
            } catch (IOException e) {
                LOG.log(Level.WARNING, "how far " + name + " has come along its list is not known to the next base", e);
            }
        }
    }

    private void keepFences(VehicleFiles files, List<String> given) {
        if (isReplaced) {
            return;
        }
        try {
            files.writeFences(name, given);
        } catch (IOException e) {
            alarm("the fence that " + name + " was given cannot be stored on this machine; a later session takes it for"
                    + " its owner's: " + e.getMessage());
        }
    }

    private void alarm(String text) {
        session.ifPresent(told -> told.alarm(text));
    }

    private void broadcast(LinkMessage message) {
        if (message instanceof Progress progress) {
            keep(progress);
        }
        LinkMessage whole = message instanceof SettingsReport report
                ? report.with(performance.now()).with(new BoatCapabilities(cannot(), sensors.channels()))
                : message;
        session.filter(BaseSession::isGreeted).ifPresent(told -> told.say(whole));
    }

    /** What it always refuses, each with the reason. */
    private Map<String, String> cannot() {
        Map<String, String> cannot = new TreeMap<>();
        cannot.put(BoatCapabilities.GAINS, "its gains are parameters of its autopilot");
        cannot.put(BoatCapabilities.WAYS_HOME, "its autopilot comes home straight, or the way that it came");
        charge.unknown().ifPresent(why -> cannot.put(BoatCapabilities.CHARGE, why));
        camera.missing().ifPresent(why -> cannot.put(BoatCapabilities.PANORAMA, why));
        return cannot;
    }

    private void reportSettings() {
        broadcast(orders.settings());
    }

    /** Whether the id of its autopilot's start is known, which a base needs at the welcome, and its speed, by which lists are compared. */
    boolean isKnown() {
        return settings.bootId().isPresent() && performance.isRead();
    }

    /** Whether the vehicle is still carrying out an order. */
    boolean isBusy() {
        return orders.isBusy();
    }

    /** The base has a new connection to it; the earlier one is ended. Who drives it by hand keeps it, also from the first base of this process. */
    void connect(VehicleConnection connection, long atMs) {
        session.ifPresent(before -> before.end("the base has connected again"));
        String takenBy = session.map(BaseSession::takenBy).orElseGet(() -> others.driver(vehicle, atMs));
        BaseSession next = new BaseSession(this, connection, takenBy);
        session = Optional.of(next);
        toldSpeech.clear();
        toldOfKeys.clear();
        connection.open(next);
        LinkNews.of(name, vehicle).forEach(news -> next.say(news.weight(), news.text()));
        kept.news().ifPresent(next::alarm);
        if (!takenBy.isEmpty()) {
            sayTaken(next, takenBy);
        }
    }

    private void sayTaken(BaseSession to, String who) {
        to.alarm(name + " is taken by " + who + ": its missions wait until you take it back");
    }

    /** How the links are and what is asked over each: told to the base. */
    void links(List<MavlinkLinkReport> links, Map<MavlinkAddress, MessagePlan> plans, long atMs) {
        session.ifPresent(told -> told.linkStatuses(VehicleLinkStatuses.of(vehicle, links, plans, atMs)));
    }

    /** A link does not work: the base is told, where it is one of this vehicle's. Whether it is, and a base is there. */
    boolean toldBroken(MavlinkAddress link, String why) {
        boolean isOwn = vehicle.links().contains(link);
        session.filter(told -> isOwn).ifPresent(told -> told.say(Priority.HIGH, link + " does not work: " + why));
        return isOwn && session.isPresent();
    }

    /** It speaks so on a link that it may not be understood, or obey: the base is told once. */
    void toldOfSpeech(MavlinkAddress link, SenderFault fault) {
        session.filter(told -> vehicle.links().contains(link) && toldSpeech.add(fault))
                .ifPresent(told -> told.say(Priority.HIGH, name + " " + fault.words()));
    }

    /** Something is to be known of the key with which its links sign: the base is told once. */
    void toldOfKey(String words) {
        session.filter(told -> toldOfKeys.add(words)).ifPresent(told -> told.say(Priority.HIGH, words));
    }

    /** The fence that it is to hold by itself. */
    void keepTo(SessionFence area) {
        fence.want(area.of(flies));
    }

    /** This is how it reports itself. */
    void reported(VehicleSnapshot now, long atMs) {
        if (now.health().outsideFence() && !vehicle.health().outsideFence()) {
            alarm(name + " says that it is outside of its own fence");
        }
        boolean another = flies && now.armed() != vehicle.armed(); // its home is where it was armed
        boolean placed = flies && now.located() && !vehicle.located();
        fence.inForce(now.health().fenceOn());
        others.reported(vehicle, now, atMs);
        vehicle = now;
        boolean isChargeNews = charge.reported(now);
        if (performance.reported(now) || isChargeNews) {
            reportSettings();
        }
        boolean isTheirs = session.filter(told -> !told.takenBy().isEmpty()).isPresent();
        boolean taken = orders.reported(now, atMs) || (!isTheirs && orders.isStartedByOthers());
        if (another || placed) {
            reportSettings();
        }
        session.filter(told -> taken).ifPresent(told -> {
            String who = others.who(now, atMs);
            sayTaken(told, who);
            told.takenBy(who);
        });
        if (taken) {
            others.read();
        }
        Optional<String> news = start.seen(now, taken || isTheirs, orders.isLatched(), () -> others.who(now, atMs));
        session.ifPresent(told -> news.ifPresent(text -> {
            told.say(Priority.CRITICAL, text);
            if (isTheirs) {
                told.takenBy(others.who(now, atMs));
            }
        }));
        learnedWho(atMs);
    }

    /** What was heard tells more of who has it. */
    private void learnedWho(long atMs) {
        session.ifPresent(told -> others.better(told.takenBy(), vehicle, atMs).ifPresent(who -> {
            start.known(told.takenBy(), who);
            urgent(name + " is controlled by " + who);
            told.takenBy(who);
        }));
    }

    /** Whether this vehicle is another one than that whose list and state were read, as its number tells, which it has said late. */
    boolean isAnotherByLateNumber(VehicleSnapshot now) {
        return now.number().filter(kept::isOfAnother).isPresent();
    }

    /**
     * Another vehicle answers with its id: nothing goes there that was meant for this one, and the base connects anew to what is there.
     *
     * @return what the operator is to be told, where no base is there to tell it
     */
    Optional<String> replaced(VehicleKind now) {
        isReplaced = true;
        orders.replaced();
        String where = vehicle.links().get(0).toString();
        String before = KindWords.of(kind);
        String what = now == kind
                ? "another " + before + " answers with the number of " + name + " on " + where
                        + ": its autopilot has another number. Its mission"
                : name + " was a " + before + ", and a " + KindWords.of(now) + " answers with its number now on "
                        + where + ". The mission of the " + before;
        String words = what + " is not sent to it. Look what is there before you command it, and give each vehicle a"
                + " system id of its own";
        boolean isTold = session.filter(BaseSession::isGreeted).isPresent();
        urgent(words);
        session.ifPresent(told -> {
            told.givenBack();
            told.end("another vehicle answers with its number");
        });
        return isTold ? Optional.empty() : Optional.of(words);
    }

    /** Tells the operator what must not wait. */
    void urgent(String words) {
        session.ifPresent(told -> told.say(Priority.CRITICAL, words));
    }

    /** Whether this is the autopilot for which it stands, as a system may have several. */
    boolean is(VehicleId id) {
        return vehicle.id().equals(id);
    }

    /** Something happened to it. */
    void happened(VehicleEvent event, long atMs) {
        if (others.happened(event, atMs)) {
            learnedWho(atMs);
        }
        if (event instanceof VehicleEvent.Restarted) {
            settings.read();
            performance.read();
            camera.read();
            fence.restarted();
            orders.restarted();
            others.restarted();
            session.ifPresent(told -> {
                told.givenBack();
                told.end("its autopilot has started again");
            });
        } else if (event instanceof VehicleEvent.ClockBehind) {
            settings.clockBehind();
        } else if (event instanceof VehicleEvent.Said said) {
            texts.weigh(said.text(), orders.causes(said.text()), atMs)
                    .ifPresent(weight -> session.ifPresent(told -> told.say(weight, texts.words(said.text()))));
            orders.happened(event);
        } else if (event instanceof VehicleEvent.Measured measured) {
            VehicleReports.reading(vehicle, measured.reading(), Math.max(0, atMs))
                    .ifPresent(report -> {
                        if (sensors.isNew(report)) {
                            reportSettings();
                        }
                        broadcast(report);
                    });
        } else if (event instanceof VehicleEvent.CommandProgressed progressed) {
            progress(progressed);
        } else if (event instanceof VehicleEvent.ParameterReported parameter) {
            settings.failsafe().reported(parameter.name(), parameter.value());
            fence.reported(parameter.name(), parameter.value());
        } else if (event instanceof VehicleEvent.PictureTaken picture) {
            broadcast(VehicleReports.picture(picture, Math.max(0, atMs)));
            camera.taken(picture);
        } else if (event instanceof VehicleEvent.LinkJoined
                || event instanceof VehicleEvent.LinkChanged
                || event instanceof VehicleEvent.OtherVehicle
                || event instanceof VehicleEvent.SharedId) {
            LinkNews.of(name, event).ifPresent(news -> session.ifPresent(told -> told.say(news.weight(), news.text())));
        } else if (event instanceof VehicleEvent.TargetTracked target) {
            targets.report(vehicle, target, atMs).ifPresent(this::broadcast);
        } else {
            orders.happened(event);
        }
    }

    /** Each percentage once, as vehicles say it again and again. */
    private void progress(VehicleEvent.CommandProgressed news) {
        String words = name + " is at it: " + news.does() + ", " + news.percent() + " %";
        if (!words.equals(toldProgress)) {
            toldProgress = words;
            session.ifPresent(told -> told.say(Priority.LOW, words));
        }
    }

    void tick(long atMs) {
        tickMs = atMs;
        orders.tick(atMs);
        camera.tick(atMs);
        boolean isCommanded = session.filter(BaseSession::isCommanded).isPresent();
        fence.tick(atMs, isCommanded);
        settings.failsafe().tick(atMs, isCommanded);
        if (session.filter(BaseSession::isGreeted).isEmpty()) {
            return;
        }
        BaseSession told = session.get();
        boolean isFresh = atMs - vehicle.heardMs() <= FRESH_MS;
        boolean news = isFresh && vehicle.heardMs() > heardMs; // no heartbeat goes out while the vehicle is silent
        boolean moved = isFresh
                && vehicle.position()
                        .filter(at -> at.heardMs() > positionMs)
                        .isPresent(); // an old position is not repeated as a new one
        if (moved && atMs - saidMs >= told.telemetryPeriodMs() - TICK_MS) {
            VehicleReports.telemetry(vehicle, charge.percent(), orders.mode(), orders.givesWayTo(), Math.max(0, atMs))
                    .ifPresent(telemetry -> {
                        saidMs = atMs;
                        positionMs = vehicle.position().orElseThrow().heardMs();
                        heardMs = vehicle.heardMs();
                        beatMs = atMs;
                        told.say(telemetry);
                    });
        }
        reportMotion(told);
        if (news && atMs - beatMs >= HEARTBEAT_MS) {
            heardMs = vehicle.heardMs();
            beatMs = atMs;
            told.beat(atMs);
        }
        reportBattery(told, atMs);
    }

    /** Each of its positions, while another boat is near and it moves. */
    private void reportMotion(BaseSession told) {
        BoatMode mode = orders.mode();
        vehicle.position()
                .filter(at -> at.heardMs() > Math.max(motionMs, positionMs)
                        && (mode == BoatMode.PATH || at.speedMps() > STILL_MPS)
                        && orders.isNearOthers(at))
                .flatMap(at -> VehicleReports.motion(vehicle, mode))
                .ifPresent(motion -> {
                    motionMs = vehicle.position().orElseThrow().heardMs();
                    told.say(motion);
                });
    }

    private void reportBattery(BaseSession told, long atMs) {
        Optional<BatteryReport> now = charge.report(others.isBatteryFailsafe(vehicle, atMs));
        boolean another = !now.map(BatteryReport::level).equals(battery.map(BatteryReport::level));
        if (now.isPresent() && (another || atMs - batteryMs >= BATTERY_MS)) {
            batteryMs = atMs;
            told.say(now.get());
        }
        battery = now;
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public String bootId() {
        return settings.bootId().orElseThrow(); // before it is known the base is not connected
    }

    @Override
    public void execute(CommandMessage command, String clientId, Consumer<LinkMessage> answer) {
        if (command instanceof TakePanorama panorama) {
            camera.take(panorama, answer);
        } else {
            orders.execute(command, clientId, answer);
        }
    }

    @Override
    public void teleoperate(double thrust, double rudder) {
        orders.teleoperate(thrust, rudder);
    }

    @Override
    public void near(Traffic traffic) {
        orders.near(traffic);
    }

    @Override
    public void introduce() {
        charge.report(others.isBatteryFailsafe(vehicle, tickMs)).ifPresent(this::broadcast);
        broadcast(orders.settings());
        Progress progress = orders.progress();
        broadcast(progress);
        camera.read();
        others.read();
        settings.failsafe().askSoon();
        fence.askSoon();
        if (!flies) { // copters are not steered around others
            avoidance.read();
        }
    }

    @Override
    public void left() {
        orders.left();
    }
}
