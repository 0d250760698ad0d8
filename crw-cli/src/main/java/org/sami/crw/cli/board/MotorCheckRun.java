package org.sami.crw.cli.board;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.sami.boat.hull.board.BoardListener;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.board.BoardVehicle;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.settings.HullFile;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.settings.MotorAnswer;
import org.sami.boat.hull.settings.MotorCheck;
import org.sami.boat.link.SteadyClock;

/**
 * The guided check of a hull's motors in a terminal: it drives, asks what was seen, and writes the settings of the hull at its end. A check that is left before
 * its end writes nothing.
 *
 * @param in what the person types, a line for each answer
 */
record MotorCheckRun(String name, BufferedReader in, PrintWriter out) {
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    private static final long BOARD_WAIT_MS = 5000;

    MotorCheckRun {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(in, "in");
        Objects.requireNonNull(out, "out");
    }

    /**
     * Goes through the check.
     *
     * @param file where the settings are written
     * @return whether it came to its end
     * @throws IOException that says why the board cannot be had, or the file not be written
     */
    boolean run(DevicePort device, HullSettings hull, Path file, SteadyClock clock) throws IOException {
        try (BoardVehicle board = new BoardVehicle(hull, new PositionFilter(), device.port(), clock, new Board())) {
            DeviceOpening.open("--board", device, board::openFirst);
            board.start();
            awaitBoard(board, device, clock);
            say("Check of the motors of " + name + ". Tie the boat up, and keep hands off the propellers.");
            MotorCheck check = new MotorCheck(hull, board);
            while (check.step().isPresent()) {
                board.setHull(check.settings());
                if (!ask(check)) {
                    board.drive(0, 0, 0);
                    say("The check is left; " + file + " stays as it was.");
                    return false;
                }
                if (!check.trouble().isEmpty()) {
                    say(check.trouble());
                }
            }
            HullFile.write(file, check.settings());
            say(words(check.settings()) + ". Written to " + file + ".");
            return true;
        }
    }

    private static void awaitBoard(BoardVehicle board, DevicePort device, SteadyClock clock) throws IOException {
        long untilMs = clock.getAsLong() + BOARD_WAIT_MS;
        while (board.boardState() != BoardState.CONNECTED) {
            if (clock.getAsLong() > untilMs) {
                throw new IOException(device.port().name()
                        + " (--board): it says nothing that can be read; look at the board's " + "power and its cable");
            }
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }

    /** One question, until it has an answer; whether it has. */
    private boolean ask(MotorCheck check) throws IOException {
        List<MotorAnswer> answers = check.step().orElseThrow().answers();
        boolean driven = false;
        while (true) {
            say("");
            say(check.question());
            say("  " + (driven ? choices(answers) + "   " : later(answers)) + "Enter: drive" + (driven ? " again" : "")
                    + "   q: leave");
            String line = in.readLine();
            if (line == null || line.strip().equals("q")) {
                return false;
            }
            Optional<MotorAnswer> chosen = chosen(answers, line.strip());
            if (line.isBlank()) {
                driven = check.drive();
                if (!driven) {
                    say("Nothing is driven: the board is not there.");
                }
            } else if (chosen.isPresent() && (driven || chosen.get() == MotorAnswer.LATER)) {
                check.answer(chosen.get());
                return true;
            } else {
                say(driven || chosen.isEmpty() ? "'" + line.strip() + "' is none of these." : "Drive it first: Enter.");
            }
        }
    }

    private static String choices(List<MotorAnswer> answers) {
        List<String> words = new ArrayList<>();
        for (MotorAnswer answer : answers) {
            words.add(words.size() + 1 + ": " + answer.words());
        }
        return String.join("   ", words);
    }

    private static String later(List<MotorAnswer> answers) {
        int at = answers.indexOf(MotorAnswer.LATER);
        return at < 0 ? "" : at + 1 + ": " + MotorAnswer.LATER.words() + "   ";
    }

    private static Optional<MotorAnswer> chosen(List<MotorAnswer> answers, String typed) {
        return typed.matches("[1-9]") && Integer.parseInt(typed) <= answers.size()
                ? Optional.of(answers.get(Integer.parseInt(typed) - 1))
                : Optional.empty();
    }

    private static String words(HullSettings hull) {
        List<String> found = new ArrayList<>();
        found.add(String.format(
                Locale.ROOT,
                "Most thrust %d %%, trim %d %%",
                Math.round(hull.safeMaximum() * 100),
                Math.round(hull.trim() * 100)));
        boolean rudder = hull.kind() == HullKind.RUDDER;
        if (hull.sidesSwapped()) {
            found.add("motors swapped");
        }
        if (hull.leftReversed()) {
            found.add(rudder ? "motor reversed" : "left motor reversed");
        }
        if (hull.rightReversed()) {
            found.add("right motor reversed");
        }
        if (rudder && hull.rudderReversed()) {
            found.add("rudder reversed");
        }
        return String.join(", ", found);
    }

    private void say(String text) {
        out.println(text);
        out.flush();
    }

    /** What the board tells meanwhile. */
    private final class Board implements BoardListener {
        @Override
        public void stateChanged(BoardState state, String why) {
            if (state != BoardState.CONNECTED) {
                say("The board is " + state.name().toLowerCase(Locale.ROOT) + (why.isEmpty() ? "" : ": " + why));
            }
        }

        @Override
        public void boardError(String error, String arguments) {
            say("The board reports an error: " + error + " " + arguments);
        }

        @Override
        public void garbled(String line, long count) {
            say("The board's lines are damaged (" + count + " so far): look at its cable");
        }
    }
}
