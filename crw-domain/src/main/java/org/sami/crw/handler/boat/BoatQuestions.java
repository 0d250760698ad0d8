package org.sami.crw.handler.boat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.proxy.status.LinkState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;

/**
 * Questions to the operator about single boats outside of plans: whether a restarted boat may move again, and whether another base may take one. The
 * handler carries out the answer on the boat. The session's journal keeps the last known start of each boat, so that a restart while the base was
 * down is noticed too, and who wishes to command it, so that an answer to an earlier process counts. For the fleet's thread; it passes the engine's steps on to it.
 */
public final class BoatQuestions implements Consumer<FleetEvent>, HostListener {
    private static final String NOBODY = "";

    private final EngineHost host;
    private final ProxyRegistry boats;
    private final Executor fleet;
    private final Map<String, String> askers = new TreeMap<>(); // by boat, the base that wishes to command it
    private final RestartQuestion restarts;

    public BoatQuestions(EngineHost host, ProxyRegistry boats, Executor fleet) {
        this.host = host;
        this.boats = boats;
        this.fleet = fleet;
        restarts = new RestartQuestion(host);
    }

    @Override
    public void accept(FleetEvent event) {
        if (event instanceof FleetEvent.LinkChanged link) {
            onLinkChange(link.status());
        } else if (event instanceof FleetEvent.Restarted restarted) {
            onRestarted(restarted.status());
        } else if (event instanceof FleetEvent.StatusReported) {
            restarts.askIfDue();
        } else if (event instanceof FleetEvent.RestartAllowed allowed) {
            onRestartAllowed(allowed.status());
        } else if (event instanceof FleetEvent.CommandAsked asked) {
            onCommandAsked(asked.boat(), asked.client());
        } else if (event instanceof FleetEvent.CommanderChanged commander && !commander.commands()) {
            withdrawAsked(commander.boat());
        } else if (event instanceof FleetEvent.Retired retired) {
            onRetired(retired.boat());
        }
    }

    private void onLinkChange(BoatStatus status) {
        if (status.link() == LinkState.LINKED) {
            SessionMemory.BOOT
                    .of(status.boatId(), host)
                    .ifPresentOrElse(
                            known -> boats.find(status.boatId()).ifPresent(proxy -> proxy.knownBoot(known)),
                            () -> remember(status));
        }
    }

    private void remember(BoatStatus status) {
        host.post(SessionMemory.BOOT.remember(status.boatId(), status.bootId()));
    }

    private void onRestarted(BoatStatus status) {
        restarts.add(status.boatId());
    }

    private void onRestartAllowed(BoatStatus status) {
        remember(status);
        restarts.remove(status.boatId());
    }

    private void onCommandAsked(String boatId, String clientId) {
        withdrawAsked(boatId);
        askers.put(boatId, clientId);
        host.post(List.of(
                SessionMemory.ASKER.remember(boatId, clientId),
                new Input.AskOperator(
                        DomainQuestion.COMMAND_ASKED.kind(),
                        boatId,
                        clientId + " wishes to command " + boatId + ". Is it to have it?",
                        Priority.HIGH)));
    }

    private void withdrawAsked(String boatId) {
        if (takeAsker(boatId).isPresent()) {
            withdraw(DomainQuestion.COMMAND_ASKED, boatId);
        }
    }

    /** The base that wishes to command a boat, which was asked about by this process or an earlier one; nobody is asked about it any more. */
    private Optional<String> takeAsker(String boatId) {
        Optional<String> asker = Optional.ofNullable(askers.remove(boatId))
                .or(() -> SessionMemory.ASKER.of(boatId, host).filter(known -> !known.isEmpty()));
        if (asker.isPresent()) {
            host.post(SessionMemory.ASKER.remember(boatId, NOBODY));
        }
        return asker;
    }

    private void onRetired(String boatId) {
        takeAsker(boatId);
        restarts.remove(boatId);
        for (DomainQuestion question : DomainQuestion.values()) {
            if (question != DomainQuestion.BOAT_RESTARTED) {
                withdraw(question, boatId);
            }
        }
    }

    private void withdraw(DomainQuestion question, String boatId) {
        boolean open = host.ask(view ->
                view.decisions().stream().anyMatch(decision -> decision.type().equals(question.kind())));
        if (open) {
            host.post(new Input.WithdrawQuestion(question.kind(), boatId));
        }
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        for (Effect effect : effects) {
            if (effect instanceof Effect.QuestionAnswered answered) {
                fleet.execute(() -> carryOut(answered));
            }
        }
    }

    private void carryOut(Effect.QuestionAnswered answered) {
        if (answered.kind().equals(DomainQuestion.BOAT_RESTARTED.kind())) {
            restarts.answered(answered).forEach(allowed -> boats.find(allowed).ifPresent(BoatProxy::confirmRestart));
            return;
        }
        Optional<BoatProxy> boat = boats.find(answered.about());
        if (boat.isEmpty()) {
            return;
        }
        DomainQuestion.of(answered.kind()).ifPresent(question -> {
            if (question == DomainQuestion.COMMAND_ASKED) {
                takeAsker(answered.about())
                        .filter(client -> answered.yes())
                        .ifPresent(boat.get().handOver()::grantCommand);
            }
        });
    }
}
