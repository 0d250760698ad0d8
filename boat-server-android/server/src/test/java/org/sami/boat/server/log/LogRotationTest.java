package org.sami.boat.server.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.Random;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;

/** A log begins new files, and whatever happens meanwhile, a restarted boat knows what it knew. */
class LogRotationTest {
    private static final int COMMANDS = 110;

    @TempDir
    private Path folder;

    private final List<String> faults = new ArrayList<>();

    private LogPlace place(long bytes) {
        return new LogPlace(folder.resolve("anna.log"), bytes);
    }

    private final class Listed implements LogFaults {
        @Override
        public void unwritable(IOException cause) {
            faults.add("unwritable: " + cause.getMessage());
        }

        @Override
        public void oversized(IOException cause) {
            faults.add("oversized: " + cause.getMessage());
        }

        @Override
        public void mended() {
            faults.add("mended");
        }
    }

    private CommandLogFile open(LogDisk disk, Executor aside, CarriedState state) throws IOException {
        return CommandLogFile.open(disk, aside, place(CommandLogFile.LEAST_BYTES), "b", state, new Listed());
    }

    private String reopened() throws IOException {
        CarriedState state = new CarriedState();
        open(new LogDisk(), Runnable::run, state).close();
        return text(state);
    }

    private static String text(CarriedState state) {
        return state.head("any").text();
    }

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().collect(Collectors.toList());
        }
    }

    /** Commands of every kind, by three clients, with ids that are said again. */
    private static List<LoggedCommand> commands(int count) {
        Random random = new Random(5);
        List<LoggedCommand> all = new ArrayList<>();
        String list = "";
        for (int i = 0; i < count; i++) {
            String id = "c" + (random.nextInt(8) == 0 ? i / 2 : i);
            CommandMessage command = command(random, id, list);
            list = command instanceof UploadWaypoints upload ? upload.listId() : list;
            LinkMessage answer = random.nextInt(6) == 0 && !(command instanceof UploadWaypoints)
                    ? new Nack(id, NackReason.FLEET_STOPPED, "")
                    : new Ack(id);
            all.add(new LoggedCommand("b", i, "base " + random.nextInt(3), command, answer));
        }
        return all;
    }

    private static CommandMessage command(Random random, String id, String list) {
        List<Waypoint> points =
                Collections.nCopies(1 + random.nextInt(9), new Waypoint(45 + random.nextDouble(), 10, 1));
        return switch (random.nextInt(11)) {
            case 0, 1 -> new UploadWaypoints(id, "l" + random.nextInt(3), points);
            case 2 -> new SetWaysHome(id, list.isEmpty() ? "l0" : list, List.of(List.of(points)));
            case 3 -> new StartWaypoints(id, list.isEmpty() ? "l0" : list, 0);
            case 4 -> new StopMotors(id);
            case 5 -> new FleetStop(id);
            case 6 -> new FleetRelease(id);
            case 7 -> new SetGains(id, List.of(GainAxis.values()).get(random.nextInt(2)), random.nextInt(9), 0, 0);
            case 8 -> new SetVelocityMultiplier(id, random.nextInt(9));
            case 9 -> new SetLostLinkAction(id, List.of(LostLinkAction.values()).get(random.nextInt(4)));
            default -> new TakeCommand(id, "session", 1 + random.nextInt(9));
        };
    }

    /** What a restarted boat knows after each of the commands, beginning with none. */
    private static List<String> states(List<LoggedCommand> commands) {
        CarriedState state = new CarriedState();
        List<String> all = new ArrayList<>(List.of(text(state)));
        for (LoggedCommand command : commands) {
            state.answered(command);
            all.add(text(state));
        }
        return all;
    }

    private static void say(CommandLogFile log, LoggedCommand command) {
        log.answered(command.timeMs(), command.clientId(), command.command(), command.answer());
    }

    @Test
    void newFilesCarryWhatARestartedBoatNeedsAndOldOnesCanGo() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        try (CommandLogFile log = open(new LogDisk(), Runnable::run, new CarriedState())) {
            commands.forEach(command -> say(log, command));
        }
        assertThat(names()).contains("anna.log.000001", "anna.log.000002").noneMatch(name -> name.endsWith(".part"));
        assertThat(faults).isEmpty();

        List<String> logs = names().stream()
                .filter(new LogFiles(folder.resolve("anna.log"))::isOne)
                .collect(Collectors.toList());
        for (String old : logs.subList(0, logs.size() - 1)) {
            Files.delete(folder.resolve(old));
        }
        assertThat(reopened()).isEqualTo(states(commands).get(COMMANDS));
    }

    @Test
    void processThatDiesAtAnyStepForgetsNothingThatItHasAnswered() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        List<String> states = states(commands);
        for (int lag : new int[] {0, 3}) {
            int step = 0;
            for (boolean died = true; died; step++) {
                clear();
                FailingDisk disk = new FailingDisk(step, step % 200);
                int answered = run(disk, lag, commands);
                died = answered < COMMANDS;
                disk.close();

                assertThat(states.subList(answered, Math.min(answered + 2, states.size())))
                        .as("dead at step %s, %s answered", step, answered)
                        .contains(reopened());
            }
            assertThat(step).as("steps").isGreaterThan(COMMANDS + 10);
        }
    }

    @Test
    void lossOfPowerAtAnyStepLosesTheLastCommandsAtMost() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        List<String> states = states(commands);
        for (int seed = 0; seed < 2; seed++) {
            int step = 0;
            for (boolean died = true; died; step++) {
                clear();
                FailingDisk disk = new FailingDisk(step, step % 200);
                int answered = run(disk, seed * 3, commands);
                died = answered < COMMANDS;
                int newest = newestForced(disk);
                disk.losePower(new Random(31L * step + seed));

                assertThat(reopened())
                        .as("no power at step %s, %s answered", step, answered)
                        .isIn(states.subList(0, Math.min(answered + 2, states.size())));
                assertThat(new LogFiles(folder.resolve("anna.log")).byNumber().lastKey())
                        .as("newest file")
                        .isGreaterThanOrEqualTo(newest);
            }
        }
    }

    private int newestForced(FailingDisk disk) {
        LogFiles files = new LogFiles(folder.resolve("anna.log"));
        int newest = 0;
        for (int number = 1; number < 20; number++) {
            newest = disk.hasForced(files.file(number)) ? number : newest;
        }
        return newest;
    }

    private void clear() throws IOException {
        for (String name : names()) {
            Files.delete(folder.resolve(name));
        }
    }

    /** How many commands were answered before it died; the disk's thread is so many commands behind. */
    private int run(FailingDisk disk, int lag, List<LoggedCommand> commands) throws IOException {
        Queue<Runnable> work = new ArrayDeque<>();
        int answered = 0;
        int waits = 0;
        try {
            CommandLogFile log = open(disk, lag == 0 ? Runnable::run : work::add, new CarriedState());
            for (LoggedCommand command : commands) {
                say(log, command);
                answered++;
                waits = work.isEmpty() ? 0 : waits + 1;
                if (waits > lag) {
                    work.remove().run();
                }
            }
        } catch (FailingDisk.Death e) {
            return answered == commands.size() ? answered - 1 : answered;
        }
        return answered;
    }

    @Test
    void allFilesAreReadAsOneWithoutWhatTheyRepeat() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        for (int lag : new int[] {0, 1, 7}) {
            clear();
            FailingDisk disk = new FailingDisk(Integer.MAX_VALUE, 0);
            run(disk, lag, commands);
            disk.close();
            List<String> read = new ArrayList<>();
            int unread = LogHistory.read(
                    new LogFiles(folder.resolve("anna.log")),
                    entry -> read.add(entry.timeMs() + " " + entry.command().commandId()));

            assertThat(unread).isZero();
            List<String> said = commands.stream()
                    .map(entry -> entry.timeMs() + " " + entry.command().commandId())
                    .collect(Collectors.toList());
            assertThat(read)
                    .as("%s commands behind, without the files that are gone", lag)
                    .hasSizeGreaterThan(COMMANDS / 4)
                    .isEqualTo(said.subList(said.size() - read.size(), said.size()));
        }
    }

    @Test
    void newestFileWhoseHeadADiskHasLostIsReadWithTheOneBefore() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        try (CommandLogFile log = open(new LogDisk(), Runnable::run, new CarriedState())) {
            commands.forEach(command -> say(log, command));
        }
        LogFiles files = new LogFiles(folder.resolve("anna.log"));
        int newest = files.byNumber().lastKey();
        CarriedState before = new CarriedState();
        for (Path file : files.byNumber().headMap(newest).values()) {
            LogLines.read(file, before);
        }
        byte[] whole = Files.readAllBytes(files.file(newest));
        Path kept = Files.copy(files.file(newest - 1), folder.resolve("kept"));
        for (int length : new int[] {0, 1, 20, 60, 500, 3000}) {
            Files.copy(kept, files.file(newest - 1), StandardCopyOption.REPLACE_EXISTING);
            Files.write(files.file(newest), Arrays.copyOf(whole, length));

            assertThat(reopened()).as("%s bytes", length).isEqualTo(text(before));
            int next = files.byNumber().lastKey();
            assertThat(next).as("a whole file was begun").isEqualTo(newest + 1);
            Files.delete(files.file(newest - 1));
            assertThat(reopened()).isEqualTo(text(before));
            Files.delete(files.file(next));
        }
    }

    @Test
    void allFilesTogetherStayUnderTheirSize() throws IOException {
        long limit = 1 << 20;
        CommandLogFile log =
                CommandLogFile.open(new LogDisk(), Runnable::run, place(limit), "b", entry -> {}, new Listed());
        LogFiles files = new LogFiles(folder.resolve("anna.log"));
        for (int i = 0; i < 700; i++) {
            List<Waypoint> points = Collections.nCopies(150, new Waypoint(45.123456789, 10.123456789 + i / 10.0, 1));
            log.answered(i, "base", new UploadWaypoints("u" + i, "l" + i, points), new Ack("u" + i));
            long sum = 0;
            for (Path file : files.byNumber().values()) {
                sum += Files.size(file);
            }
            assertThat(sum).as("after %s commands", i).isLessThan(limit);
        }
        log.close();

        assertThat(files.byNumber().firstKey()).as("old files are gone").isGreaterThan(0);
        assertThat(files.byNumber()).as("others stay").hasSizeGreaterThan(2);
    }

    @Test
    void fullDiskStopsNoBoatAndTheLogIsWholeOnceThereIsRoom() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        FailingDisk disk = new FailingDisk(Integer.MAX_VALUE, 0);
        CommandLogFile log = open(disk, Runnable::run, new CarriedState());
        for (int i = 0; i < 40; i++) {
            say(log, commands.get(i));
        }
        disk.full = true;
        for (int i = 40; i < 60; i++) {
            say(log, commands.get(i));
        }
        assertThat(faults).containsExactly("unwritable: No space left on device");

        disk.full = false;
        for (int i = 60; i < COMMANDS; i++) { // it tries again after some time
            LoggedCommand command = commands.get(i);
            log.answered(60_000 + i, command.clientId(), command.command(), command.answer());
        }
        assertThat(faults).containsExactly("unwritable: No space left on device", "mended");
        log.close();
        assertThat(reopened()).isEqualTo(states(commands).get(COMMANDS));
    }

    @Test
    void logThatCannotBeginANewFileGrowsAndSaysSo() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        Path inTheWay = folder.resolve("anna.log.000001.part");
        CommandLogFile log = open(new LogDisk(), Runnable::run, new CarriedState());
        Files.createDirectories(inTheWay.resolve("full"));
        for (int i = 0; i < 80; i++) {
            say(log, commands.get(i));
        }
        assertThat(faults).singleElement().asString().startsWith("oversized: ");
        assertThat(Files.size(folder.resolve("anna.log"))).isGreaterThan(CommandLogFile.LEAST_BYTES / 8);

        Files.delete(inTheWay.resolve("full"));
        Files.delete(inTheWay);
        for (int i = 80; i < COMMANDS; i++) {
            LoggedCommand command = commands.get(i);
            log.answered(60_000 + i, command.clientId(), command.command(), command.answer());
        }
        assertThat(faults).hasSize(2).contains("mended");
        log.close();
        assertThat(reopened()).isEqualTo(states(commands).get(COMMANDS));
    }

    @Test
    void longLogOfAnEarlierVersionIsTakenOver() throws IOException {
        List<LoggedCommand> commands = commands(COMMANDS);
        StringBuilder text = new StringBuilder();
        commands.forEach(command -> text.append(LogLines.command(command)));
        Files.write(folder.resolve("anna.log"), text.toString().getBytes(java.nio.charset.StandardCharsets.UTF_8));

        try (CommandLogFile log = open(new LogDisk(), Runnable::run, new CarriedState())) {
            log.answered(1, "base", new StopMotors("s"), new Ack("s"));
            log.answered(2, "base", new StopMotors("t"), new Ack("t"));
        }
        commands.add(new LoggedCommand("b", 1, "base", new StopMotors("s"), new Ack("s")));
        commands.add(new LoggedCommand("b", 2, "base", new StopMotors("t"), new Ack("t")));
        assertThat(names()).contains("anna.log.000001");
        assertThat(reopened()).isEqualTo(states(commands).get(COMMANDS + 2));
    }

    @Test
    void logsOfOtherBoatsInTheFolderStay() throws IOException {
        List<String> others =
                List.of("anna.log.log", "anna.log.1", "anna.log.000001.log", "bert.log.000009", "anna-2.log");
        for (String other : others) {
            Files.write(folder.resolve(other), new byte[0], StandardOpenOption.CREATE_NEW);
        }
        try (CommandLogFile log = open(new LogDisk(), Runnable::run, new CarriedState())) {
            commands(COMMANDS).forEach(command -> say(log, command));
        }
        assertThat(names()).containsAll(others);
        assertThat(new LogFiles(folder.resolve("anna.log")).byNumber().values())
                .noneMatch(file -> others.contains(file.getFileName().toString()));
    }
}
