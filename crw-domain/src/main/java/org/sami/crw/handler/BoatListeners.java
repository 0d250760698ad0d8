package org.sami.crw.handler;

import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.proxy.BatteryState;
import org.sami.crw.proxy.BoatCommand;
import org.sami.crw.proxy.BoatListener;
import org.sami.crw.proxy.BoatStatus;
import org.sami.crw.proxy.Withdrawal;

/** Several listeners as one, told in order. */
final class BoatListeners implements BoatListener {
    private final List<BoatListener> listeners;

    BoatListeners(BoatListener... listeners) {
        this.listeners = List.of(listeners);
    }

    @Override
    public void onCompleted(String boatId, BoatCommand command) {
        each(listener -> listener.onCompleted(boatId, command));
    }

    @Override
    public void onFailed(String boatId, BoatCommand command, String reason) {
        each(listener -> listener.onFailed(boatId, command, reason));
    }

    @Override
    public void onWithdrawn(String boatId, BoatCommand command, Withdrawal why) {
        each(listener -> listener.onWithdrawn(boatId, command, why));
    }

    @Override
    public void onProgress(String boatId, BoatCommand command, int visitedCount) {
        each(listener -> listener.onProgress(boatId, command, visitedCount));
    }

    @Override
    public void onStatus(BoatStatus status) {
        each(listener -> listener.onStatus(status));
    }

    @Override
    public void onLinkChange(BoatStatus status) {
        each(listener -> listener.onLinkChange(status));
    }

    @Override
    public void onBattery(String boatId, BatteryState battery) {
        each(listener -> listener.onBattery(boatId, battery));
    }

    @Override
    public void onRestarted(BoatStatus status) {
        each(listener -> listener.onRestarted(status));
    }

    private void each(Consumer<BoatListener> news) {
        listeners.forEach(news);
    }
}
