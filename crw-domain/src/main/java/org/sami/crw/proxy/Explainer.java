package org.sami.crw.proxy;

import java.util.Optional;

/** Answers "why is this boat not moving?" from its proxy's link and queue. */
final class Explainer {
    private final BoatProxy proxy;

    Explainer(BoatProxy proxy) {
        this.proxy = proxy;
    }

    Explanation explain() {
        String obstacle = proxy.obstacle();
        if (!obstacle.isEmpty()) {
            int commands = proxy.driver().queue().size();
            return waits(obstacle + (commands == 0 ? "" : "; " + counted(commands)));
        }
        if (proxy.driver().run().isPresent()) {
            return running(proxy.driver().run().get());
        }
        if (proxy.driver().isStopping()) {
            return waits("no mission wants anything of it; it is being stopped");
        }
        Optional<Long> blocker = proxy.driver().queue().blockedBy();
        if (blocker.isPresent()) {
            int commands = proxy.driver().queue().size();
            return waits("mission " + blocker.get() + " keeps it where it is"
                    + (commands == 0 ? "" : "; " + counted(commands)));
        }
        return waits("no mission wants anything of it");
    }

    private Explanation running(CommandRun run) {
        BoatCommand command = run.queued().command();
        String name = command.commandId() + " of mission " + command.mission();
        boolean empty = proxy.status()
                .battery()
                .filter(battery -> battery.percent() <= 0)
                .isPresent();
        if (empty) {
            return waits("its battery is empty; it should do " + name);
        }
        String state = name + ": " + run.state() + visited(run.queued()) + sends();
        return new Explanation(run.isDriving(), proxy.boatId() + (run.isDriving() ? " does " : " waits: ") + state);
    }

    private static String visited(QueuedCommand queued) {
        return queued.command() instanceof FollowPath path
                ? ", " + queued.visited() + " of " + path.points().size() + " points visited"
                : "";
    }

    private String sends() {
        int sends = proxy.driver().sends();
        return sends > 1 ? ", sent " + sends + " times without an answer" : "";
    }

    private static String counted(int commands) {
        return commands == 1 ? "one command waits" : commands + " commands wait";
    }

    private Explanation waits(String why) {
        return new Explanation(false, proxy.boatId() + " does not move: " + why);
    }
}
